#pragma once
/// \file
/// Shapes of which distances are known, and surfaces that are put elsewhere.

#include <cmath>
#include <string>

#include "certet/distance.hpp"
#include "certet/shape.hpp"

namespace certet::shapes {

inline ShapeDomain shape(const std::string& text, double size) {
  return {text, std::nullopt, size, 2};
}

/// The surface of its mesh.
inline MeshSurface meshed(const PlacedDomain& domain) {
  Context context;
  return surface_of(mesh(domain), context);
}

inline DistanceFigures measured(const MeshSurface& mesh, const PlacedDomain& domain) {
  Context context;
  return measure_distance(mesh, domain, context);
}

inline MeshSurface shifted(MeshSurface surface, const Point3& by) {
  for (Point3& point : surface.points)
    for (std::size_t a = 0; a < 3; ++a) point[a] += by[a];
  return surface;
}

inline double length(const Point3& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

}  // namespace certet::shapes
