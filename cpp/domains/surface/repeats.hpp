#pragma once
/// \file
/// Triangles that are not needed.

#include <cstdint>
#include <span>
#include <vector>

#include "edges.hpp"

namespace certet {

/// Drops the triangles of which this says so.  Returns how many.
std::uint64_t drop_triangles(TriangleSurface& surface, const std::vector<bool>& dropped);

/// Drops triangles that have a point twice.  Returns how many.
std::uint64_t drop_collapsed(TriangleSurface& surface);

/// Whether two of the triangles along an edge have the same third point.
bool has_repeats(const TriangleSurface& surface, std::span<const TriangleSide> edge);

/// Of triangles with the same three corners keeps one, or none.  Those that share
/// edges are a patch, which is kept or dropped as fewer of its edges are open then.
/// Where both are the same, what runs around one way more often than the other is
/// kept; what has as many of both is a sheet in space, and dropped, unless it is
/// closed and nothing is attached to it: then it is a solid whose every triangle has
/// both its sides.  Returns how many triangles were dropped.
std::uint64_t drop_repeats(TriangleSurface& surface);

}  // namespace certet
