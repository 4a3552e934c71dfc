#pragma once
/// \file
/// The surface of a shape, as far as distances need it.

#include <optional>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "shape_points.hpp"
#include "sides.hpp"
#include "triangle_tree.hpp"

namespace certet::distance {

class Ball;

/// By its triangles, if they are known and all of them are part of it; else by what it answers.
class ShapeSurface {
 public:
  ShapeSurface(const PlacedDomain& domain, bool materials, Context& context);

  [[nodiscard]] bool is_exact() const { return triangles_.has_value(); }
  /// Those at which it is measured.
  [[nodiscard]] const std::vector<ShapePoint>& points() const { return points_; }

  /// How far points are from it, in lattice units.  \throws Error `empty_domain` where it has no
  /// points; what the domain throws.
  [[nodiscard]] std::vector<double> distances(std::span<const Point3> points,
                                              Context& context) const;

 private:
  void by_answers(std::span<const Point3> points, std::span<double> out, Context& context) const;
  void reach_far_ones(std::span<Ball> balls, Context& context) const;

  Sides sides_;
  std::optional<TriangleTree> triangles_;
  std::vector<ShapePoint> points_;
};

}  // namespace certet::distance
