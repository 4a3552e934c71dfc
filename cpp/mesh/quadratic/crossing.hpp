#pragma once
/// \file
/// Where the surface passes a straight edge's middle.

#include <span>

#include "certet/domain.hpp"
#include "surface_edges.hpp"

namespace certet::quadratic {

/// What was found near a middle.
enum class Found {
  moved,       ///< the surface, aside of it
  on_surface,  ///< that it lies on the surface
  far,         ///< no surface
};

struct Crossing {
  Found found = Found::far;
  Coord3 bend{};  ///< in half steps
};

/// Looks for the surface along the normals of edges, outward from a middle that is inside and
/// inward from one that is not: at an eighth, a quarter, a half and all of a quarter of the
/// edge's length, and then by bisection, to one step of the normal's greatest extent.  An
/// answer depends on its own edge alone.  `out` is as long as `edges`.
void find_crossings(std::span<const SurfaceEdge> edges, const Domain& domain,
                    std::span<Crossing> out);

}  // namespace certet::quadratic
