#pragma once
/// \file
/// Solids below a level of a gray image, or between two.

#include <limits>

#include "certet/image.hpp"

namespace certet {

/// Gray values that are inside; both ends are not.
struct GrayLevels {
  double above = -std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
};

/// An image of how far each voxel is within the levels: the lesser of the distances to both,
/// negative outside.  The solid of its level 0 is that of the levels.  Between two voxels of
/// which one is below and one above both levels there is no sheet.
/// \throws Error `bad_option` where the levels are not ascending, or none is finite.
Image between_levels(const Image& image, const GrayLevels& levels);

}  // namespace certet
