#pragma once
/// \file
/// Triangles of a surface that pass through each other.

#include "certet/surface.hpp"

namespace certet {

/// The pairs of triangles of which one has an edge that passes through the
/// other: its ends lie on different sides of the plane, neither of them in it,
/// and what is between meets the triangle.  Neighbours meet in points of both,
/// which lie in either plane, so that they are no such pair unless they also
/// meet elsewhere.  \throws Error `cancelled`, after some ten thousand pairs.
SurfaceDefect find_self_intersections(const TriangleSurface& surface, const Context& context);

}  // namespace certet
