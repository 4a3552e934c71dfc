#include "overlap.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace thin {
namespace {

/// 2^19 at most between corners of tetrahedra whose boxes overlap, so that dot products
/// of differences with cross products of edges stay below 2^62.
using Vector = std::array<std::int64_t, 3>;
using Corners = std::array<Vector, 4>;

Vector between(const Vector& a, const Vector& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From the lowest corner to the highest along an axis.
std::pair<std::int64_t, std::int64_t> reach(const Corners& t, const Vector& axis) {
  std::array<std::int64_t, 4> at;
  for (std::size_t n = 0; n < 4; ++n) at[n] = dot(t[n], axis);
  const auto [low, high] = std::ranges::minmax(at);
  return {low, high};
}

/// Whether a plane across the axis has the one on one side and the other on the other.
bool separates(const Vector& axis, const Corners& a, const Corners& b) {
  if (axis == Vector{0, 0, 0}) return false;
  const auto [a_low, a_high] = reach(a, axis);
  const auto [b_low, b_high] = reach(b, axis);
  return a_high <= b_low || b_high <= a_low;
}

constexpr std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
constexpr std::array<std::array<std::size_t, 2>, 6> edges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

bool a_face_separates(const Corners& of, const Corners& a, const Corners& b) {
  return std::ranges::any_of(faces, [&](const auto& f) {
    return separates(cross(between(of[f[0]], of[f[1]]), between(of[f[0]], of[f[2]])), a, b);
  });
}

/// Two polyhedra that are convex are apart exactly if a plane along a face of either, or
/// along an edge of each, separates them.
bool apart(const Corners& a, const Corners& b) {
  if (a_face_separates(a, a, b) || a_face_separates(b, a, b)) return true;
  for (const auto& e : edges)
    for (const auto& f : edges)
      if (separates(cross(between(a[e[0]], a[e[1]]), between(b[f[0]], b[f[1]])), a, b)) return true;
  return false;
}

struct Boxed {
  const exact::Tet* tet;
  std::array<std::int32_t, 3> low, high;
};

Boxed boxed(const exact::Tet& tet) {
  const auto along = [&](std::int32_t certet::Coord3::*axis) {
    return std::minmax({tet[0].*axis, tet[1].*axis, tet[2].*axis, tet[3].*axis});
  };
  const auto x = along(&certet::Coord3::x);
  const auto y = along(&certet::Coord3::y);
  const auto z = along(&certet::Coord3::z);
  return {&tet, {x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

bool boxes_meet(const Boxed& a, const Boxed& b) {
  for (std::size_t n = 0; n < 3; ++n)
    if (a.high[n] <= b.low[n] || b.high[n] <= a.low[n]) return false;
  return true;
}

Corners seen_from(certet::Coord3 origin, const exact::Tet& tet) {
  Corners corners;
  for (std::size_t n = 0; n < 4; ++n) {
    const certet::Coord3 d = tet[n] - origin;
    corners[n] = {d.x, d.y, d.z};
  }
  return corners;
}

}  // namespace

Overlaps overlaps(const std::vector<exact::Tet>& tets) {
  std::vector<Boxed> boxes;
  boxes.reserve(tets.size());
  for (const exact::Tet& tet : tets) boxes.push_back(boxed(tet));
  std::ranges::sort(boxes, {}, [](const Boxed& b) { return b.low[0]; });
  Overlaps result;
  for (std::size_t n = 0; n < boxes.size(); ++n)
    for (std::size_t m = n + 1; m < boxes.size() && boxes[m].low[0] < boxes[n].high[0]; ++m) {
      if (!boxes_meet(boxes[n], boxes[m])) continue;
      ++result.looked_at;
      const certet::Coord3 origin = (*boxes[n].tet)[0];
      result.found += !apart(seen_from(origin, *boxes[n].tet), seen_from(origin, *boxes[m].tet));
    }
  return result;
}

}  // namespace thin
