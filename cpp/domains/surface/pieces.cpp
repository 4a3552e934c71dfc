#include <algorithm>
#include <set>
#include <vector>

#include "certet/surface.hpp"
#include "edges.hpp"
#include "engine/disjoint_sets.hpp"
#include "exact.hpp"
#include "inside.hpp"
#include "rounding.hpp"
#include "triangle_columns.hpp"

namespace certet {
namespace {

using exact::Nudge;

/// Triangles joined by edges of just two, by the least number of each.
std::vector<std::uint32_t> shells_of(const TriangleSurface& surface) {
  DisjointSets sets(surface.triangles.size());
  for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
    if (edge.size() == 2) sets.join(edge[0].triangle, edge[1].triangle);
  });
  std::vector<std::uint32_t> shell(surface.triangles.size());
  for (std::uint32_t t = 0; t < shell.size(); ++t) shell[t] = sets.find(t);
  return shell;
}

/// Which shells bound pieces from outside.
class OuterShells {
 public:
  OuterShells(const TriangleSurface& surface, const std::vector<std::uint32_t>& shell)
      : parity_(closed_rule(surface) == Rule::parity), shell_(shell),
        columns_(rounded(surface), surface.triangles) {}

  /// Whether outside of a shell is outside of the solid, by what is beyond the middle of its
  /// largest triangle, seen along x; nothing where another shell touches that point.
  [[nodiscard]] std::optional<bool> is_outer(std::uint32_t triangle) const {
    const auto [a, b, c] = columns_.corners(triangle);
    const auto third = [](std::int64_t u, std::int64_t v, std::int64_t w) {
      return static_cast<std::int32_t>((u + v + w) / 3);
    };
    const Coord3 middle{third(a.x, b.x, c.x), third(a.y, b.y, c.y), third(a.z, b.z, c.z)};
    int winding = 0;
    bool touched = false;
    columns_.for_each_number_ahead(middle, [&](std::uint32_t other) {
      if (shell_[other] == shell_[triangle]) return;
      const exact::Corners t = columns_.corners(other);
      const exact::Normal n = exact::normal(t);
      touched = touched || exact::touches(t, n, middle);
      const int direction = exact::passing(t, middle, Nudge::forward);
      if (direction != 0 && exact::ahead(t, n, direction, middle, Nudge::forward))
        winding += direction;
    });
    if (touched) return std::nullopt;
    return parity_ ? winding % 2 == 0 : winding == 0;
  }

  /// Of the triangle's box, so that it is the same on every machine.
  [[nodiscard]] std::int64_t extent(std::uint32_t triangle) const {
    const exact::Corners t = columns_.corners(triangle);
    const auto width = [&](auto axis) {
      const auto [low, high] = std::minmax({axis(t[0]), axis(t[1]), axis(t[2])});
      return exact::gap(low, high);
    };
    return width([](Coord3 p) { return p.x; }) + width([](Coord3 p) { return p.y; }) +
           width([](Coord3 p) { return p.z; });
  }

 private:
  bool parity_;
  const std::vector<std::uint32_t>& shell_;
  TriangleColumns columns_;
};

/// Shells that have points in common, joined.
DisjointSets joined_by_points(const TriangleSurface& surface,
                              const std::vector<std::uint32_t>& shell) {
  DisjointSets sets(surface.triangles.size());
  std::vector<std::uint32_t> first(surface.points.size(), none);
  for (std::uint32_t t = 0; t < shell.size(); ++t)
    for (const std::uint32_t point : surface.triangles[t]) {
      if (first[point] == none) first[point] = shell[t];
      sets.join(first[point], shell[t]);
    }
  return sets;
}

}  // namespace

std::optional<PieceBounds> pieces_of(const TriangleSurface& surface,
                                     const SurfaceDefects& defects, const Context& context) {
  refuse_malformed(surface);
  if (!defects.closed() || defects.self_intersections.count != 0) return std::nullopt;
  const std::vector<std::uint32_t> shell = shells_of(surface);
  const OuterShells shells(surface, shell);
  std::vector<std::uint32_t> largest(shell.size(), none);
  for (std::uint32_t t = 0; t < shell.size(); ++t) {
    std::uint32_t& of = largest[shell[t]];
    if (of == none || shells.extent(t) > shells.extent(of)) of = t;
  }
  DisjointSets touching = joined_by_points(surface, shell);
  std::set<std::uint32_t> groups;
  PieceBounds pieces;
  for (std::uint32_t t = 0; t < shell.size(); ++t) {
    if (largest[t] == none) continue;
    stop_if_cancelled(context);
    const std::optional<bool> outer = shells.is_outer(largest[t]);
    if (!outer) return std::nullopt;
    if (!*outer) continue;
    ++pieces.most;
    groups.insert(touching.find(t));
  }
  pieces.least = groups.size();
  return pieces;
}

}  // namespace certet
