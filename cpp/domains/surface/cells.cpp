#include "cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/disjoint_sets.hpp"
#include "edges.hpp"
#include "patches.hpp"
#include "repeats.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// A triangle around an edge.
struct Leaf {
  double angle;
  std::uint32_t patch;
  bool backward;
};

/// The triangles around an edge, anticlockwise seen against its direction, and the
/// least height of one over it, in lengths of the edge.
struct Fan {
  std::vector<Leaf> leaves;
  double height = INFINITY;
};

class Cells {
 public:
  Cells(TriangleSurface& surface, SurfacePatches patches)
      : surface_(surface), patches_(std::move(patches)), cells_(2 * patches_.count),
        components_(patches_.count) {
    find_cells();
    find_areas();
    find_outermost();
    find_voids();
  }

  /// Returns how many triangles it dropped.
  std::uint64_t keep_hull(std::uint64_t& turned) {
    std::vector<bool> dropped(surface_.triangles.size(), false);
    for (std::uint32_t t = 0; t < dropped.size(); ++t) {
      const std::uint32_t patch = patches_.of[t];
      if (!meets_others(patch)) continue;
      const bool front = is_void(side(patch, true)), back = is_void(side(patch, false));
      dropped[t] = front == back;
      if (!front && back) {
        std::swap(surface_.triangles[t][1], surface_.triangles[t][2]);
        ++turned;
      }
    }
    return drop_triangles(surface_, dropped);
  }

 private:
  /// The side of a patch that its normals point to, and the other.
  static std::uint32_t side(std::uint32_t patch, bool front) { return 2 * patch + !front; }

  [[nodiscard]] bool meets_others(std::uint32_t patch) { return met_.contains(components_.find(patch)); }
  [[nodiscard]] bool is_void(std::uint32_t side) { return void_[cells_.find(side)]; }

  /// Patches meet along many edges; the one whose triangles are highest is the
  /// surest about their order.
  void find_cells() {
    std::map<std::vector<std::uint32_t>, Fan> surest;
    for_each_edge(sides_of(surface_), [&](std::span<const TriangleSide> edge) {
      if (edge.size() == 2) return;
      Fan fan = around(edge);
      std::vector<std::uint32_t> key;
      for (const Leaf& leaf : fan.leaves) key.push_back(side(leaf.patch, leaf.backward));
      std::sort(key.begin(), key.end());
      Fan& known = surest[std::move(key)];
      if (known.leaves.empty() || fan.height > known.height) known = std::move(fan);
    });
    for (const auto& [key, fan] : surest) {
      for (std::size_t i = 0; i < fan.leaves.size(); ++i) {
        const Leaf &one = fan.leaves[i], &next = fan.leaves[(i + 1) % fan.leaves.size()];
        // Of a triangle that runs along the edge, front is the anticlockwise side.
        cells_.join(side(one.patch, !one.backward), side(next.patch, next.backward));
        components_.join(one.patch, next.patch);
      }
      if (fan.leaves.size() > 2) joints_.push_back(fan.leaves[0].patch);
    }
    for (const std::uint32_t patch : joints_) met_[components_.find(patch)] = {};
  }

  [[nodiscard]] Fan around(std::span<const TriangleSide> edge) const {
    const Point3 &low = surface_.points[edge[0].low()], &high = surface_.points[edge[0].high()];
    const Point3 along = difference(high, low);
    const double square = dot(along, along);
    Fan fan;
    Point3 zero{}, right{};
    for (const TriangleSide& s : edge) {
      const std::uint32_t opposite = surface_.triangles[s.triangle][(s.corner + 2U) % 3];
      const Point3 to = difference(surface_.points[opposite], low);
      const double share = square > 0 ? dot(to, along) / square : 0;
      const Point3 out{to[0] - share * along[0], to[1] - share * along[1],
                       to[2] - share * along[2]};
      if (fan.leaves.empty()) {
        zero = out;
        right = cross(along, out);
        for (double& c : right) c /= std::sqrt(std::max(square, 1e-300));
      }
      fan.leaves.push_back(
          {std::atan2(dot(out, right), dot(out, zero)), patches_.of[s.triangle], s.backward});
      fan.height = std::min(fan.height, length(out) / std::sqrt(std::max(square, 1e-300)));
    }
    std::sort(fan.leaves.begin(), fan.leaves.end(), [](const Leaf& a, const Leaf& b) {
      return std::tie(a.angle, a.patch) < std::tie(b.angle, b.patch);
    });
    return fan;
  }

  void find_areas() {
    area_.assign(patches_.count, 0);
    for (std::size_t n = 0; n < surface_.triangles.size(); ++n) {
      const auto& t = surface_.triangles[n];
      area_[patches_.of[n]] += length(area_vector(surface_.points[t[0]], surface_.points[t[1]],
                                                  surface_.points[t[2]]));
    }
  }

  /// Of each component, along a line in x through the middle of the triangle with
  /// the greatest shadow, the last triangle is seen from outside.
  void find_outermost() {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (const auto met = met_.find(components_.find(patches_.of[t])); met != met_.end())
        met->second.triangles.push_back(t);
    for (auto& [component, met] : met_) {
      const std::uint32_t widest = *std::max_element(
          met.triangles.begin(), met.triangles.end(), [this](std::uint32_t a, std::uint32_t b) {
            return std::fabs(normal(a)[0]) < std::fabs(normal(b)[0]);
          });
      const Point3 middle = centre(widest);
      double farthest = -INFINITY;
      for (const std::uint32_t t : met.triangles) {
        const double x = where_met(t, middle);
        if (!(x > farthest)) continue;
        farthest = x;
        met.outermost = side(patches_.of[t], normal(t)[0] > 0);
      }
    }
  }

  [[nodiscard]] Point3 normal(std::uint32_t triangle) const {
    const auto& t = surface_.triangles[triangle];
    return area_vector(surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
  }

  [[nodiscard]] Point3 centre(std::uint32_t triangle) const {
    Point3 sum{};
    for (const std::uint32_t p : surface_.triangles[triangle])
      for (std::size_t a = 0; a < 3; ++a) sum[a] += surface_.points[p][a] / 3;
    return sum;
  }

  /// The x at which a line through a point meets a triangle, or minus infinity.
  [[nodiscard]] double where_met(std::uint32_t triangle, const Point3& p) const {
    const auto& t = surface_.triangles[triangle];
    const Point3 n = normal(triangle);
    if (n[0] == 0) return -INFINITY;
    for (std::size_t c = 0; c < 3; ++c) {
      const Point3 &a = surface_.points[t[c]], &b = surface_.points[t[(c + 1) % 3]];
      const double turn = (b[1] - a[1]) * (p[2] - a[2]) - (b[2] - a[2]) * (p[1] - a[1]);
      if (turn * n[0] < 0) return -INFINITY;
    }
    const Point3& a = surface_.points[t[0]];
    return a[0] - (n[1] * (p[1] - a[1]) + n[2] * (p[2] - a[2])) / n[0];
  }

  /// A cell is void where all its walls show the side that the outside mostly sees.
  void find_voids() {
    std::vector<double> fronts(cells_count(), 0), backs(cells_count(), 0);
    for (std::uint32_t patch = 0; patch < patches_.count; ++patch) {
      fronts[cells_.find(side(patch, true))] += area_[patch];
      backs[cells_.find(side(patch, false))] += area_[patch];
    }
    void_.assign(cells_count(), false);
    for (std::uint32_t s = 0; s < cells_count(); ++s) {
      const auto met = met_.find(components_.find(s / 2));
      if (cells_.find(s) != s || met == met_.end()) continue;
      const std::uint32_t outside = cells_.find(met->second.outermost);
      const bool inside_out = backs[outside] > fronts[outside];
      void_[s] = s == outside || (inside_out ? fronts[s] : backs[s]) == 0;
    }
  }

  [[nodiscard]] std::uint32_t cells_count() const { return 2 * patches_.count; }

  /// A component in which more than two triangles meet.
  struct Met {
    std::vector<std::uint32_t> triangles;
    std::uint32_t outermost = 0;  ///< a side that is seen from outside
  };

  TriangleSurface& surface_;
  SurfacePatches patches_;
  DisjointSets cells_;       ///< of sides of patches
  DisjointSets components_;  ///< of patches
  std::vector<std::uint32_t> joints_;
  std::map<std::uint32_t, Met> met_;
  std::vector<double> area_;
  std::vector<bool> void_;
};

}  // namespace

bool keep_hull(TriangleSurface& surface, SurfaceRepairs& repairs) {
  TriangleSurface tried = surface;
  SurfaceRepairs done = repairs;
  SurfacePatches patches = agreed_patches(tried, done.turned_triangles);
  if (!patches.orientable) return false;
  done.inner_triangles += Cells(tried, std::move(patches)).keep_hull(done.turned_triangles);
  if (tried.triangles.empty()) return false;
  for (const SurfaceEdge& edge : edges_of(tried))
    if (edge.odd() || edge.misoriented()) return false;
  surface = std::move(tried);
  repairs = done;
  return true;
}

}  // namespace certet
