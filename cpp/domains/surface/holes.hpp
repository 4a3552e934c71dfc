#pragma once
/// \file
/// Loops of edges at which a surface ends.

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

/// Loops along which a surface ends, as its triangles run: each edge as often as more of
/// them run along it that way than the other.  None of a surface that is closed and agrees.
std::vector<HoleLoop> rim_loops(const TriangleSurface& surface);

}  // namespace certet
