#pragma once
/// \file
/// The nearest of many triangles.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/frame.hpp"

namespace certet::distance {

using Triangle = std::array<std::uint32_t, 3>;

/// Two or all three corners may be one point.
struct Corners {
  Point3 a, b, c;
};

/// The point of a triangle that is nearest to another.
Point3 nearest_on(const Corners& triangle, const Point3& point);

/// The nearest triangle, and how far it is.
struct Nearest {
  double square;  ///< of the distance
  std::uint32_t triangle;
};

/// A binary tree of boxes around triangles, halved along the longest axis.
class TriangleTree {
 public:
  /// At least one.
  TriangleTree(std::vector<Point3> points, std::vector<Triangle> triangles);

  [[nodiscard]] Nearest nearest(const Point3& point) const;
  [[nodiscard]] Corners corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    return {points_[a], points_[b], points_[c]};
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;

  struct Box {
    Point3 low, high;
    void add(const Point3& point);
    [[nodiscard]] double square_from(const Point3& point) const;
  };
  struct Node {
    Box box;
    std::uint32_t begin, end;  ///< in `order_`
    std::uint32_t second = 0;  ///< the other half; the first follows.  0: a leaf
  };

  void build(std::uint32_t begin, std::uint32_t end);
  [[nodiscard]] Box box_of(std::uint32_t begin, std::uint32_t end) const;
  void look_at(const Node& leaf, const Point3& point, Nearest& best) const;

  std::vector<Point3> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace certet::distance
