#pragma once
/// \file
/// Colours that can be told apart by everybody, on light and on dark ground.

#include <array>
#include <cstddef>
#include <cstdint>

namespace certet::view {

/// Red, green, blue in sRGB.
using Rgb = std::array<std::uint8_t, 3>;

/// The number of hues for regions.
inline constexpr std::size_t hues = 8;

/// A hue, in one of three shades.
Rgb region_color(std::size_t hue, std::size_t shade);

/// The worst angle that a tetrahedron can have at best: that of a regular one.
inline constexpr double best_angle = 70.528779365509308;

/// From red at 0° to blue at the best angle.
Rgb angle_color(double worst_angle);

}  // namespace certet::view
