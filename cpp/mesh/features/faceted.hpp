#pragma once
/// \file
/// Triangles that share their points, their normals, and their edges.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/placed_domain.hpp"
#include "vectors.hpp"

namespace certet::features {

/// One side of a triangle, between two points of growing numbers.
struct Side {
  std::uint32_t low, high, triangle;
  bool backward;  ///< the triangle runs from `high` to `low`
};

class Faceted {
 public:
  explicit Faceted(std::span<const TriangleCorners> triangles);

  [[nodiscard]] std::size_t size() const { return triangles_.size(); }
  [[nodiscard]] Coord3 point(std::uint32_t number) const { return points_[number]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  /// Those of an edge, one after the other; triangles that have a point twice have none.
  [[nodiscard]] std::span<const Side> sides() const { return sides_; }
  [[nodiscard]] double edge_length(const Side& side) const;
  /// Between the normals of the triangles of an edge, in degrees; 180 where there are not two.
  [[nodiscard]] double angle_at(std::span<const Side> edge) const;

  /// Calls visit(sides) for each edge.
  template <class Visit>
  void visit_edges(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].low == sides_[begin].low &&
             sides_[end].high == sides_[begin].high)
        ++end;
      visit(std::span<const Side>(sides_).subspan(begin, end - begin));
    }
  }

 private:
  /// Of a triangle that is too thin, the normal of a neighbour.
  void mend_normals();

  std::vector<Coord3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Side> sides_;
  std::vector<Vector> normals_;  ///< of length 1, or 0
};

}  // namespace certet::features
