#include "merge_points.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "certet/surface.hpp"
#include "edges.hpp"
#include "point_grid.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// The points that triangles have, equal ones next to each other.
std::vector<std::uint32_t> sorted_points(const TriangleSurface& surface) {
  std::vector<bool> used(surface.points.size(), false);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t point : triangle) used[point] = true;
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = 0; p < used.size(); ++p)
    if (used[p]) order.push_back(p);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(surface.points[a], a) < std::tie(surface.points[b], b);
  });
  return order;
}

}  // namespace

void merge_equal_points(TriangleSurface& surface) {
  refuse_malformed(surface);
  std::vector<Point3>& points = surface.points;
  // The first of equal points stands for all; those that stay keep their order.
  std::vector<std::uint32_t> first(points.size(), none), number(points.size(), none);
  std::uint32_t before = none;
  for (const std::uint32_t p : sorted_points(surface)) {
    first[p] = before != none && points[before] == points[p] ? before : p;
    before = first[p];
  }
  std::uint32_t kept = 0;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if (first[p] != p) continue;
    points[kept] = points[p];
    number[p] = kept++;
  }
  points.resize(kept);
  for (auto& triangle : surface.triangles)
    for (std::uint32_t& point : triangle) point = number[first[point]];
}

std::uint64_t weld_points(TriangleSurface& surface, const std::vector<bool>& movable,
                          double tolerance) {
  const std::vector<Point3>& points = surface.points;
  std::vector<std::uint32_t> stands(points.size());
  std::iota(stands.begin(), stands.end(), 0U);
  PointGrid kept(tolerance);
  std::uint64_t gone = 0;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if (!movable[p]) continue;
    kept.for_each_near(points[p], [&](std::uint32_t other) {
      if (distance(points[p], points[other]) <= tolerance)
        stands[p] = std::min(stands[p], other);
    });
    if (stands[p] == p) kept.add(p, points[p]);
    else ++gone;
  }
  for (auto& triangle : surface.triangles)
    for (std::uint32_t& point : triangle) point = stands[point];
  return gone;
}

}  // namespace certet
