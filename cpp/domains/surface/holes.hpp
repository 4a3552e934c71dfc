#pragma once
/// \file
/// Loops of open edges, and what closes them.

#include <cstdint>
#include <vector>

#include "certet/surface.hpp"

namespace certet {

/// Numbers of points around a hole; each point once.
using HoleLoop = std::vector<std::uint32_t>;

/// The loops that the edges of one triangle make, in the order of their edges; what
/// is left where they make none (they end at edges of three) is left out.
std::vector<HoleLoop> hole_loops(const TriangleSurface& surface);

SurfaceHoles measure_holes(const TriangleSurface& surface, const std::vector<HoleLoop>& loops);

/// Adds triangles that close the loops.  A loop of few points is closed by triangles
/// between them whose area is the least; one of more by cutting ears off it; one of
/// more than some hundreds by a fan around a new point in its middle.  The triangles run
/// along the loop the other way than what is around the hole at its first edge.
void close_holes(TriangleSurface& surface, const std::vector<HoleLoop>& loops);

}  // namespace certet
