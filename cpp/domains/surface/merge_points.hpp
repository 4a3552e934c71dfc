#pragma once
/// \file
/// Points that become one.

#include <cstdint>
#include <vector>

#include "certet/surface.hpp"

namespace certet {

/// Of points of these triangles that are no farther apart than the tolerance the
/// first stands for all, if `movable` says so of them; no two points that stay are
/// as near as that.  The others keep their numbers, and no triangle has them any
/// more.  Returns how many there are.
std::uint64_t weld_points(TriangleSurface& surface, const std::vector<bool>& movable,
                          double tolerance);

}  // namespace certet
