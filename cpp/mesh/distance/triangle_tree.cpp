#include "triangle_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "vectors.hpp"

namespace certet::distance {
namespace {

double square_between(const Point3& a, const Point3& b) {
  const Point3 d = difference(a, b);
  return dot(d, d);
}

Point3 nearest_on(const Point3& a, const Point3& b, const Point3& point) {
  const Point3 along = difference(b, a);
  const double square = dot(along, along);
  if (!(square > 0)) return a;
  return between(a, b, std::clamp(dot(difference(point, a), along) / square, 0.0, 1.0));
}

}  // namespace

Point3 nearest_on(const Corners& t, const Point3& point) {
  const Point3 n = normal(t.a, t.b, t.c);
  const double square = dot(n, n);
  const auto left_of = [&](const Point3& from, const Point3& to) {
    return dot(normal(from, to, point), n) >= 0;
  };
  if (square > 0 && left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a))
    return difference(point, scaled(dot(difference(point, t.a), n) / square, n));
  Point3 best = nearest_on(t.a, t.b, point);
  for (const auto& [from, to] : {std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
    const Point3 other = nearest_on(from, to, point);
    if (square_between(other, point) < square_between(best, point)) best = other;
  }
  return best;
}

void TriangleTree::Box::add(const Point3& point) {
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::min(low[a], point[a]);
    high[a] = std::max(high[a], point[a]);
  }
}

double TriangleTree::Box::square_from(const Point3& point) const {
  double square = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double beyond = std::max({low[a] - point[a], 0.0, point[a] - high[a]});
    square += beyond * beyond;
  }
  return square;
}

TriangleTree::TriangleTree(std::vector<Point3> points, std::vector<Triangle> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(order_.size());
  build(0, static_cast<std::uint32_t>(order_.size()));
}

TriangleTree::Box TriangleTree::box_of(std::uint32_t begin, std::uint32_t end) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far, far}, {-far, -far, -far}};
  for (std::uint32_t i = begin; i < end; ++i)
    for (const std::uint32_t point : triangles_[order_[i]]) box.add(points_[point]);
  return box;
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t at = nodes_.size();
  const Box box = box_of(begin, end);
  nodes_.push_back({box, begin, end});
  if (end - begin <= leaf_size) return;
  std::size_t axis = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (box.high[a] - box.low[a] > box.high[axis] - box.low[axis]) axis = a;
  const auto key = [&](std::uint32_t triangle) {
    const auto& [a, b, c] = triangles_[triangle];
    return std::pair(points_[a][axis] + points_[b][axis] + points_[c][axis], triangle);
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  build(begin, middle);
  nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

void TriangleTree::look_at(const Node& leaf, const Point3& point, Nearest& best) const {
  for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
    const std::uint32_t triangle = order_[i];
    const double square = square_between(nearest_on(corners(triangle), point), point);
    if (square < best.square) best = {square, triangle};
  }
}

Nearest TriangleTree::nearest(const Point3& point) const {
  Nearest best{std::numeric_limits<double>::infinity(), order_.front()};
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const Node& node = nodes_[at];
    if (!(node.box.square_from(point) < best.square)) continue;
    if (node.second == 0) {
      look_at(node, point, best);
      continue;
    }
    // The nearer half is looked at first.
    const bool first = nodes_[at + 1].box.square_from(point) <=
                       nodes_[node.second].box.square_from(point);
    open.push_back(first ? node.second : at + 1);
    open.push_back(first ? at + 1 : node.second);
  }
  return best;
}

}  // namespace certet::distance
