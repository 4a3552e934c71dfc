#include "holes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "edges.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// From one point to another.
struct Way {
  std::uint32_t from, to;
};

/// An end of a way at a point.
struct End {
  std::uint32_t point, edge, other;
};

/// Walks along ways, each of them once.
class Walk {
 public:
  Walk(std::span<const Way> ways, std::size_t points)
      : walked_(ways.size(), false), position_(points, none) {
    for (const Way& way : ways) {
      const auto number = static_cast<std::uint32_t>(starts_.size());
      starts_.push_back(way.from);
      ends_.push_back({way.from, number, way.to});
      ends_.push_back({way.to, number, way.from});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return std::pair(a.point, a.edge) < std::pair(b.point, b.edge);
    });
  }

  std::vector<HoleLoop> loops() && {
    for (std::uint32_t edge = 0; edge < starts_.size(); ++edge)
      if (!walked_[edge]) from(edge);
    return std::move(loops_);
  }

 private:
  void from(std::uint32_t edge) {
    path_.clear();
    step_to(starts_[edge]);
    for (std::uint32_t at = starts_[edge];;) {
      const End* const next = way_from(at, edge);
      if (next == nullptr) break;
      walked_[next->edge] = true;
      edge = none;
      at = next->other;
      if (position_[at] == none) step_to(at);
      else cut_loop(at);
    }
    for (const std::uint32_t point : path_) position_[point] = none;
  }

  void step_to(std::uint32_t point) {
    position_[point] = static_cast<std::uint32_t>(path_.size());
    path_.push_back(point);
  }

  /// The walk has come back to a point: what is behind it is a loop.
  void cut_loop(std::uint32_t point) {
    const auto begin = path_.begin() + position_[point];
    if (path_.end() - begin > 2) loops_.emplace_back(begin, path_.end());
    for (auto at = begin + 1; at != path_.end(); ++at) position_[*at] = none;
    path_.erase(begin + 1, path_.end());
  }

  /// The way that was asked for, or the first that has not been walked; of these
  /// one that leads on in its own direction comes first.
  [[nodiscard]] const End* way_from(std::uint32_t point, std::uint32_t wanted) const {
    auto at = std::lower_bound(ends_.begin(), ends_.end(), point,
                               [](const End& end, std::uint32_t p) { return end.point < p; });
    const End* found = nullptr;
    for (; at != ends_.end() && at->point == point; ++at) {
      if (walked_[at->edge]) continue;
      if (wanted != none ? at->edge == wanted : starts_[at->edge] == point) return &*at;
      if (found == nullptr) found = &*at;
    }
    return found;
  }

  std::vector<End> ends_;              ///< sorted by their points
  std::vector<std::uint32_t> starts_;  ///< of each way
  std::vector<bool> walked_;
  std::vector<std::uint32_t> path_, position_;  ///< position_: of each point, in path_
  std::vector<HoleLoop> loops_;
};

double diagonal(const TriangleSurface& surface, const HoleLoop& loop) {
  Point3 low = surface.points[loop[0]], high = low;
  for (const std::uint32_t p : loop)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], surface.points[p][a]);
      high[a] = std::max(high[a], surface.points[p][a]);
    }
  return distance(low, high);
}

}  // namespace

std::vector<HoleLoop> hole_loops(const TriangleSurface& surface) {
  std::vector<Way> ways;
  for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
    if (edge.size() != 1) return;
    const TriangleSide& side = edge[0];
    // A hole is walked around the other way than the triangle runs.
    ways.push_back(side.backward ? Way{side.low(), side.high()} : Way{side.high(), side.low()});
  });
  return Walk(ways, surface.points.size()).loops();
}

std::vector<HoleLoop> rim_loops(const TriangleSurface& surface) {
  std::vector<Way> ways;
  for (const SurfaceEdge& edge : edges_of(surface)) {
    for (std::uint32_t n = edge.backward; n < edge.forward; ++n) ways.push_back({edge.low, edge.high});
    for (std::uint32_t n = edge.forward; n < edge.backward; ++n) ways.push_back({edge.high, edge.low});
  }
  return Walk(ways, surface.points.size()).loops();
}

SurfaceHoles measure_holes(const TriangleSurface& surface, const std::vector<HoleLoop>& loops) {
  SurfaceHoles holes;
  holes.count = loops.size();
  for (const HoleLoop& loop : loops) {
    const double size = diagonal(surface, loop);
    if (holes.largest_edges != 0 && !(size > holes.largest)) continue;
    holes.largest = size;
    holes.largest_edges = loop.size();
  }
  return holes;
}

}  // namespace certet
