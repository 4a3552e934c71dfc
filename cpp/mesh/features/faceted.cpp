#include "faceted.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace certet::features {
namespace {

/// A triangle less high than this, in steps, has no normal of its own: its corners are rounded.
constexpr double least_height = 64;

/// Of length 1, or 0 where the triangle is too thin.
Vector normal_of(Coord3 a, Coord3 b, Coord3 c) {
  const Vector p = between(a, b), q = between(a, c);
  const Vector normal = cross(p, q);
  const double longest = std::max({length(p), length(q), length(q - p)}), area = length(normal);
  return area > least_height * longest ? (1 / area) * normal : Vector{0, 0, 0};
}

bool is_none(const Vector& normal) { return normal == Vector{0, 0, 0}; }

}  // namespace

Faceted::Faceted(std::span<const TriangleCorners> triangles) {
  for (const TriangleCorners& corners : triangles)
    points_.insert(points_.end(), corners.begin(), corners.end());
  std::ranges::sort(points_);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  const auto number_of = [&](Coord3 p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points_, p) - points_.begin());
  };
  for (const TriangleCorners& corners : triangles) {
    const std::array<std::uint32_t, 3> t{number_of(corners[0]), number_of(corners[1]),
                                         number_of(corners[2])};
    const auto number = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(t);
    normals_.push_back(normal_of(corners[0], corners[1], corners[2]));
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      sides_.push_back({std::min(a, b), std::max(a, b), number, a > b});
    }
  }
  std::ranges::sort(sides_, [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  mend_normals();
}

void Faceted::mend_normals() {
  constexpr int greatest_run = 8;  // thin triangles side by side
  for (int turn = 0; turn < greatest_run; ++turn) {
    std::vector<std::pair<double, Vector>> found(size(), {0, {0, 0, 0}});
    bool any = false;
    visit_edges([&](std::span<const Side> edge) {
      if (edge.size() != 2) return;
      for (std::size_t i = 0; i < 2; ++i) {
        const Side &own = edge[i], &other = edge[1 - i];
        if (!is_none(normals_[own.triangle]) || is_none(normals_[other.triangle])) continue;
        const double sign = own.backward == other.backward ? -1 : 1, by = edge_length(own);
        if (by > found[own.triangle].first)
          found[own.triangle] = {by, sign * normals_[other.triangle]};
        any = true;
      }
    });
    if (!any) return;
    for (std::size_t t = 0; t < size(); ++t)
      if (found[t].first > 0) normals_[t] = found[t].second;
  }
}

double Faceted::edge_length(const Side& side) const {
  return length(between(points_[side.low], points_[side.high]));
}

double Faceted::angle_at(std::span<const Side> edge) const {
  if (edge.size() != 2) return 180;
  const Vector &m = normals_[edge[0].triangle], &n = normals_[edge[1].triangle];
  const double sign = edge[0].backward == edge[1].backward ? -1 : 1;
  return std::atan2(length(cross(m, n)), sign * dot(m, n)) * (180 / std::numbers::pi);
}

}  // namespace certet::features
