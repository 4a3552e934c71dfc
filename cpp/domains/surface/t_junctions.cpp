#include "t_junctions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "edges.hpp"
#include "point_grid.hpp"
#include "repeats.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// Over the longest side.
double height(const TriangleSurface& surface, const std::array<std::uint32_t, 3>& t) {
  const auto& p = surface.points;
  const double longest = std::max({distance(p[t[0]], p[t[1]]), distance(p[t[1]], p[t[2]]),
                                   distance(p[t[2]], p[t[0]])});
  return longest == 0 ? 0 : length(area_vector(p[t[0]], p[t[1]], p[t[2]])) / longest;
}

using PointsOnSide = std::vector<std::uint32_t>;

/// The points on each side of a triangle, in the order in which it runs.
struct Cut {
  std::array<PointsOnSide, 3> on;
};

class Splitting {
 public:
  Splitting(TriangleSurface& surface, std::span<const TriangleSide> odd, double tolerance)
      : surface_(surface), tolerance_(tolerance), odd_(odd),
        spacing_(chosen_spacing()), ends_(spacing_) {
    std::vector<bool> seen(surface.points.size(), false);
    for (const TriangleSide& side : odd_)
      for (const std::uint32_t end : {side.low(), side.high()}) {
        if (seen[end]) continue;
        seen[end] = true;
        ends_.add(end, surface.points[end]);
      }
  }

  std::uint64_t run() {
    std::map<std::uint32_t, Cut> cuts;
    std::uint64_t count = 0;
    for (const TriangleSide& side : odd_) {
      PointsOnSide on = points_on(side);
      if (on.empty()) continue;
      ++count;
      cuts[side.triangle].on[side.corner] = std::move(on);
    }
    for (auto& [number, cut] : cuts) {
      const std::uint32_t triangle = number;  // clang 14 captures no structured binding
      const auto corners = surface_.triangles[triangle];
      bool first = true;
      divide(corners, cut.on, [&](const std::array<std::uint32_t, 3>& piece) {
        if (first) surface_.triangles[triangle] = piece;
        else surface_.triangles.push_back(piece);
        first = false;
      });
    }
    return count;
  }

 private:
  /// The median length of the edges: half of the walks are one step, and few points
  /// are in a cube.
  [[nodiscard]] double chosen_spacing() const {
    std::vector<double> lengths;
    for (const TriangleSide& side : odd_)
      lengths.push_back(distance(surface_.points[side.low()], surface_.points[side.high()]));
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return std::max({lengths.empty() ? 0 : *middle, 4 * tolerance_, 1e-300});
  }

  [[nodiscard]] PointsOnSide points_on(const TriangleSide& side) const {
    const auto& t = surface_.triangles[side.triangle];
    const std::uint32_t from = t[side.corner], to = t[(side.corner + 1U) % 3],
                        opposite = t[(side.corner + 2U) % 3];
    const Point3 &a = surface_.points[from], &b = surface_.points[to];
    const Point3 along = difference(b, a);
    const double square = dot(along, along);
    std::vector<std::pair<double, std::uint32_t>> found;
    const double walk = std::sqrt(square) / spacing_;
    constexpr double longest_walk = 1e5;
    if (!(square > 0) || walk > longest_walk) return {};
    const auto walks = static_cast<int>(std::ceil(walk));
    for (int step = 0; step <= walks; ++step)
      ends_.for_each_near(between(a, b, step / std::max(1.0, double(walks))), [&](std::uint32_t p) {
        if (p == from || p == to || p == opposite) return;
        const Point3& point = surface_.points[p];
        const double share = dot(difference(point, a), along) / square;
        if (!(share > 0 && share < 1) || distance(point, between(a, b, share)) > tolerance_ ||
            distance(point, a) <= tolerance_ || distance(point, b) <= tolerance_)
          return;
        found.emplace_back(share, p);
      });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    PointsOnSide on;
    for (const auto& [share, p] : found) on.push_back(p);
    return on;
  }

  /// A fan from the corner opposite to a side with points; what has the other two
  /// sides is divided in turn.
  template <class Take>
  static void divide(const std::array<std::uint32_t, 3>& t, const std::array<PointsOnSide, 3>& on,
                     const Take& take) {
    std::size_t c = 0;
    while (c < 3 && on[c].empty()) ++c;
    if (c == 3) return take(t);
    const std::uint32_t a = t[c], b = t[(c + 1) % 3], top = t[(c + 2) % 3];
    PointsOnSide fan{a};
    fan.insert(fan.end(), on[c].begin(), on[c].end());
    fan.push_back(b);
    for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
      std::array<PointsOnSide, 3> rest;
      if (i + 2 == fan.size()) rest[1] = on[(c + 1) % 3];
      if (i == 0) rest[2] = on[(c + 2) % 3];
      divide({fan[i], fan[i + 1], top}, rest, take);
    }
  }

  TriangleSurface& surface_;
  double tolerance_;
  std::span<const TriangleSide> odd_;
  double spacing_;
  PointGrid ends_;
};

}  // namespace

std::vector<TriangleSide> odd_sides(const TriangleSurface& surface) {
  std::vector<TriangleSide> odd;
  for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
    if (edge.size() % 2 != 0) odd.insert(odd.end(), edge.begin(), edge.end());
  });
  return odd;
}

std::uint64_t drop_thin(TriangleSurface& surface, std::span<const TriangleSide> odd,
                        double tolerance) {
  std::vector<bool> dropped(surface.triangles.size(), false);
  bool any = false;
  for (const TriangleSide& side : odd)
    if (height(surface, surface.triangles[side.triangle]) <= tolerance)
      any = dropped[side.triangle] = true;
  return any ? drop_triangles(surface, dropped) : 0;
}

std::uint64_t split_t_junctions(TriangleSurface& surface, std::span<const TriangleSide> odd,
                                double tolerance) {
  return Splitting(surface, odd, tolerance).run();
}

}  // namespace certet
