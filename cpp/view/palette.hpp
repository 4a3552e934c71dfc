#pragma once
/// \file
/// Colours that can be told apart by everybody, on light and on dark ground.

#include <array>
#include <cstddef>
#include <cstdint>

namespace certet::view {

/// Red, green, blue in sRGB.
using Rgb = std::array<std::uint8_t, 3>;

/// The colour of a region, by its place among `regions`.
Rgb region_color(std::size_t place, std::size_t regions);

/// The worst angle that a tetrahedron can have at best: that of a regular one.
inline constexpr double best_angle = 70.528779365509308;

/// From red at 0° to blue at the best angle.
Rgb angle_color(double worst_angle);

}  // namespace certet::view
