#pragma once
/// \file
/// Points of a shape's surface.

#include <array>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "sides.hpp"

namespace certet::distance {

/// A point, in lattice units, and the area that it stands for: of the surface or, if it was found
/// along an axis, of its shadow along that.
struct ShapePoint {
  Point3 at;
  double area;
  int axis = -1;
};

/// Where lines along the axes, a lattice unit apart, pass through the surface: to a step.
/// \throws Error `cancelled`; what the domain throws.
std::vector<ShapePoint> crossings(const Sides& sides, Context& context);

/// The corners and centroids of triangles, and of the parts of those with sides longer than a
/// lattice unit.  They integrate quadratics.
/// \throws Error `cancelled`.
std::vector<ShapePoint> points_of(std::span<const TriangleCorners> triangles, Context& context);

/// Whether each of the triangles, but for those without an area, has the solid on one side and
/// none of it on the other, as far as their centroids tell.
bool all_part(std::span<const TriangleCorners> triangles, const Sides& sides, Context& context);

}  // namespace certet::distance
