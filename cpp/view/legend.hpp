#pragma once
/// \file
/// What the colours of a picture mean.

#include "certet/picture.hpp"

namespace certet::view {

/// The part of a picture's height, at its lower end, that a legend takes.
inline constexpr double legend_share = 0.1;

/// Draws the scale of distances from 0 to the greatest, with both numbers beside it.
void draw_distance_legend(Picture& picture, double greatest);

}  // namespace certet::view
