#pragma once
/// \file
/// Where a surface of triangles is no manifold.

#include <array>
#include <cstdint>
#include <span>

#include "certet/context.hpp"
#include "certet/pieces.hpp"

namespace certet::core {

/// The points of a triangle, in the order that its side gives.
using Triangle = std::array<std::uint64_t, 3>;

/// Looks around all vertices.  \throws Error `cancelled`.
SurfaceFaults find_surface_faults(std::span<const Triangle> surface,
                                  std::span<const Point3> points, Context& context);

}  // namespace certet::core
