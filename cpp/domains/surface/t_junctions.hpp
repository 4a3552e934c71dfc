#pragma once
/// \file
/// Open edges on which corners of other triangles lie.

#include <cstdint>
#include <span>
#include <vector>

#include "edges.hpp"

namespace certet {

/// The sides along edges of an odd number of triangles.
std::vector<TriangleSide> odd_sides(const TriangleSurface& surface);

/// Drops triangles with an odd side that are no higher than the tolerance.  Returns
/// how many.
std::uint64_t drop_thin(TriangleSurface& surface, std::span<const TriangleSide> odd,
                        double tolerance);

/// Cuts each triangle with an odd side on which, no farther than the tolerance from
/// it, points of other odd sides lie, in triangles that have these points too.
/// Returns how many sides were cut.
std::uint64_t split_t_junctions(TriangleSurface& surface, std::span<const TriangleSide> odd,
                                double tolerance);

}  // namespace certet
