#include "surface_edges.hpp"

#include <algorithm>
#include <cstdlib>

namespace certet::quadratic {
namespace {

using Vector = std::array<std::int64_t, 3>;

Vector to_vector(Coord3 from, Coord3 to) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y, std::int64_t{to.z} - from.z};
}

/// Twice the area, outward.
Vector normal_of(const SurfaceTriangle& triangle, const SurfacePoints& points) {
  const Coord3 a = points.at(triangle.points[0]);
  const Vector u = to_vector(a, points.at(triangle.points[1]));
  const Vector v = to_vector(a, points.at(triangle.points[2]));
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A side of a triangle, by its middle node.
struct EdgeOfTriangle {
  std::uint64_t node;
  std::size_t triangle;
  std::uint64_t a, b;
};

std::vector<EdgeOfTriangle> sides_of(const std::vector<SurfaceTriangle>& triangles,
                           const MiddleNodes& middles) {
  std::vector<EdgeOfTriangle> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = triangles[t].points[i], b = triangles[t].points[(i + 1) % 3];
      sides.push_back({middles.between(a, b), t, a, b});
    }
  std::ranges::sort(sides, [](const EdgeOfTriangle& s, const EdgeOfTriangle& t) {
    return s.node != t.node ? s.node < t.node : s.triangle < t.triangle;
  });
  return sides;
}

/// The axis that is normal to a triangle, if one is: then it lies in a face of a box along the
/// lattice.  Bisection leaves its points a few steps off that face.
std::optional<std::size_t> axis_of(const Vector& normal) {
  constexpr std::int64_t flat = 1 << 10;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t aside =
        std::max(std::abs(normal[(a + 1) % 3]), std::abs(normal[(a + 2) % 3]));
    if (aside < std::abs(normal[a]) / flat) return a;
  }
  return std::nullopt;
}

/// What the triangles around an edge say of it.  On a rim, where the surface meets a face of a
/// box along the axes of the lattice, it may move within that face; along another face not.
class EdgeView {
 public:
  EdgeView(const std::vector<SurfaceTriangle>& triangles, const SurfacePoints& points)
      : triangles_(triangles), points_(points) {}

  void add(const EdgeOfTriangle& side) {
    const SurfaceTriangle& triangle = triangles_[side.triangle];
    const Vector normal = normal_of(triangle, points_);
    if (triangle.border) return add_border(normal);
    if (!first_) first_ = &triangle;
    seam_ = seam_ || first_->labels != triangle.labels || first_->outer != triangle.outer;
    for (std::size_t a = 0; a < 3; ++a) normal_[a] += normal[a];
  }

  /// Nothing of an edge that has no surface at it.
  [[nodiscard]] std::optional<SurfaceEdge> edge(const EdgeOfTriangle& side) const {
    if (!first_) return std::nullopt;
    const Coord3 a = points_.at(side.a), b = points_.at(side.b);
    const Vector along = to_vector(a, b);
    SurfaceEdge edge{side.node, {}, normal_, {inward_[0], inward_[1], inward_[2]},
                     0,         first_->labels[0], first_->outer, seam_};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (inward_[axis] != 0) edge.normal[axis] = 0;
      edge.length = std::max(edge.length, static_cast<std::int32_t>(std::abs(along[axis])));
    }
    edge.middle2 = {std::int64_t{a.x} + b.x, std::int64_t{a.y} + b.y, std::int64_t{a.z} + b.z};
    return edge;
  }

 private:
  void add_border(const Vector& normal) {
    // What bisection found may be a step beyond the face, where all is outside.
    constexpr std::int32_t within = 4;
    if (const auto axis = axis_of(normal)) inward_[*axis] = normal[*axis] > 0 ? -within : within;
    else seam_ = true;
  }

  const std::vector<SurfaceTriangle>& triangles_;
  const SurfacePoints& points_;
  const SurfaceTriangle* first_ = nullptr;
  Vector normal_{};
  std::array<std::int32_t, 3> inward_{};  ///< along axes on which it may not move
  bool seam_ = false;
};

}  // namespace

Coord3 SurfacePoints::at(std::uint64_t point) const {
  return std::ranges::lower_bound(points_, point, {}, &Point::first)->second;
}

std::vector<SurfaceTriangle> surface_triangles(const Survey& survey) {
  std::vector<SurfaceTriangle> triangles;
  triangles.reserve(static_cast<std::size_t>(face_count(survey)));
  // Where labels are not cut apart, the boundary is one surface whatever is within.
  const bool apart = !survey.interfaces.empty();
  for (const BoundaryFace& face : survey.boundary)
    triangles.push_back({face.points, {apart ? face.label : only_label, 0},
                         face.is_cut_off, true});
  for (const Interface& interface : survey.interfaces)
    for (const BoundaryFace& face : interface.faces)
      triangles.push_back({face.points, interface.labels, false, false});
  return triangles;
}

std::vector<SurfaceEdge> surface_edges(const std::vector<SurfaceTriangle>& triangles,
                                       const MiddleNodes& middles, const SurfacePoints& points) {
  std::vector<SurfaceEdge> edges;
  const std::vector<EdgeOfTriangle> sides = sides_of(triangles, middles);
  for (auto side = sides.begin(); side != sides.end();) {
    EdgeView view(triangles, points);
    const EdgeOfTriangle& first = *side;
    for (; side != sides.end() && side->node == first.node; ++side) view.add(*side);
    if (const auto edge = view.edge(first)) edges.push_back(*edge);
  }
  return edges;
}

}  // namespace certet::quadratic
