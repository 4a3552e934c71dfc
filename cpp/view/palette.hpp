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

/// From pale where a mesh is on its shape to dark where it is farthest, as a share of that.
Rgb distance_color(double share);

/// Of what is no part of the surface, where colours tell distances.
inline constexpr Rgb within_color{0xc4, 0xca, 0xd4};

/// From red at 0° to blue at the best angle.
Rgb angle_color(double worst_angle);

}  // namespace certet::view
