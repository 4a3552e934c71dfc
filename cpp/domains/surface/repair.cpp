// From what exporters write to the surface that they mean.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "cells.hpp"
#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "edges.hpp"
#include "facing.hpp"
#include "holes.hpp"
#include "merge_points.hpp"
#include "patches.hpp"
#include "repeats.hpp"
#include "t_junctions.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// How far a surface is from closed.
struct Gaps {
  std::uint64_t open = 0, odd = 0, misoriented = 0;
  bool repeats = false;  ///< triangles of the same corners

  explicit Gaps(const TriangleSurface& surface) {
    for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
      const auto backward = std::count_if(edge.begin(), edge.end(),
                                          [](const TriangleSide& side) { return side.backward; });
      open += edge.size() == 1;
      odd += edge.size() % 2 != 0;
      misoriented += edge.size() % 2 == 0 && 2 * backward != std::ssize(edge);
      repeats = repeats || has_repeats(surface, edge);
    });
  }
  [[nodiscard]] bool closed() const { return odd == 0; }
  [[nodiscard]] bool fewer_than(const Gaps& other) const {
    return std::pair(open, odd) < std::pair(other.open, other.odd);
  }
};

/// A surface on its way.
struct State {
  TriangleSurface surface;
  SurfaceRepairs done;
};

std::vector<bool> points_of(const TriangleSurface& surface, std::span<const TriangleSide> sides) {
  std::vector<bool> points(surface.points.size(), false);
  for (const TriangleSide& side : sides) points[side.low()] = points[side.high()] = true;
  return points;
}

/// One tolerance.  Several rounds, for a triangle that is dropped or a corner that
/// moves may leave others to mend.
class Mending {
 public:
  Mending(State state, std::vector<TriangleSide> odd, double tolerance)
      : state_(std::move(state)), odd_(std::move(odd)) {
    state_.done.tolerance = tolerance;
  }

  /// Nothing where nothing was to be done, or is left.
  std::optional<State> run(const Context& context) && {
    constexpr int most_rounds = 6;
    int rounds = 0;
    while (rounds < most_rounds && !odd_.empty()) {
      stop_if_cancelled(context);
      if (!round()) break;
      ++rounds;
    }
    if (rounds == 0 || state_.surface.triangles.empty()) return std::nullopt;
    return std::move(state_);
  }

 private:
  /// Whether anything was done.
  bool round() {
    const auto& [surface, done] = state_;
    const double tolerance = done.tolerance;
    bool changed = false;
    if (tolerance > 0)
      changed |= count(state_.done.welded_points,
                       weld_points(state_.surface, points_of(surface, odd_), tolerance));
    changed |= count(state_.done.degenerate_triangles,
                     drop_thin(state_.surface, odd_, tolerance));
    changed |= count(state_.done.split_edges,
                     split_t_junctions(state_.surface, odd_, tolerance));
    return changed;
  }

  /// After each change, what it left is looked at anew.
  bool count(std::uint64_t& total, std::uint64_t more) {
    if (more == 0) return false;
    total += more;
    state_.done.degenerate_triangles += drop_collapsed(state_.surface);
    state_.done.repeated_triangles += drop_repeats(state_.surface);
    odd_ = odd_sides(state_.surface);
    return true;
  }

  State state_;
  std::vector<TriangleSide> odd_;
};

/// What is tried, ascending.
std::vector<double> tolerances(const TriangleSurface& surface) {
  Point3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  double farthest = 0;
  for (const Point3& point : surface.points)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], point[a]);
      high[a] = std::max(high[a], point[a]);
      farthest = std::max(farthest, std::fabs(point[a]));
    }
  const double diagonal = distance(low, high);
  std::vector<double> all{0};
  for (const double share : {1e-9, 1e-8, 1e-7, 1e-6, 3e-6, 1e-5}) all.push_back(share * diagonal);
  if (const double rounding = std::ldexp(4 * farthest, -24);
      rounding > all.back() && rounding < 1e-2 * diagonal)
    all.push_back(rounding);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) all.resize(1);
  return all;
}

/// With the least tolerance that closes the surface or, if none does, that leaves
/// the fewest gaps.
void mend(State& state, const Context& context) {
  Gaps least(state.surface);
  if (least.closed()) return;
  const std::vector<TriangleSide> odd = odd_sides(state.surface);
  State best = state;
  for (const double tolerance : tolerances(state.surface)) {
    std::optional<State> tried = Mending(state, odd, tolerance).run(context);
    if (!tried) continue;
    const Gaps gaps(tried->surface);
    if (!gaps.fewer_than(least)) continue;
    least = gaps;
    best = *std::move(tried);
    if (least.closed()) break;
  }
  state = std::move(best);
}

/// Drops repeats, unless that opens what was closed: a sheet that is there twice.
void drop_unneeded(State& state, const Gaps& before) {
  TriangleSurface tried = state.surface;
  const std::uint64_t dropped = drop_repeats(tried);
  if (before.closed() && !Gaps(tried).closed()) return;
  state.done.repeated_triangles += dropped;
  state.surface = std::move(tried);
}

/// Turns triangles, and drops walls, until all agree.
void agree(State& state) {
  const Gaps gaps(state.surface);
  if (gaps.open != 0 || (gaps.odd == 0 && gaps.misoriented == 0)) return;
  if (gaps.odd == 0) {
    State turned = state;
    agreed_patches(turned.surface, turned.done.turned_triangles);
    if (Gaps(turned.surface).misoriented == 0) {
      state = std::move(turned);
      return;
    }
  }
  keep_hull(state.surface, state.done);
}

/// Leaves holes to the winding number.  A sheet around which no hole is bounds nothing.
void close(State& state, const Context& context) {
  const SurfacePatches patches = agreed_patches(state.surface, state.done.turned_triangles);
  if (patches.orientable && patches.count > 1)
    state.done.turned_triangles += face_as_others(state.surface, patches, context);
  const std::vector<HoleLoop> loops = hole_loops(state.surface);
  if (loops.empty()) keep_hull(state.surface, state.done);
  else state.done.closed_holes = measure_holes(state.surface, loops);
}

}  // namespace

SurfaceRepairs repair_surface(TriangleSurface& surface, const RepairChoice& choice,
                              const Context& context) {
  merge_equal_points(surface);
  State state{std::move(surface), {}};
  state.done.name = state.surface.name;
  const std::size_t triangles = state.surface.triangles.size();
  state.done.degenerate_triangles += drop_collapsed(state.surface);
  if (state.surface.triangles.empty())
    throw Error(ErrorCode::bad_input, "'" + state.done.name + "' has " +
                                          std::to_string(triangles) +
                                          " triangles, and all of them have a corner twice");
  const Gaps gaps(state.surface);
  if (gaps.repeats) drop_unneeded(state, gaps);
  const bool agrees = gaps.closed() && gaps.misoriented == 0;
  if (!agrees || gaps.repeats) {
    mend(state, context);
    agree(state);
    if (choice.close_holes && Gaps(state.surface).open != 0) close(state, context);
    merge_equal_points(state.surface);
  }
  surface = std::move(state.surface);
  return state.done;
}

}  // namespace certet
