#include "holes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "edges.hpp"
#include "polygons.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// An end of an open edge at a point.
struct End {
  std::uint32_t point, edge, other;
};

/// Walks along open edges, each of them once.
class Walk {
 public:
  explicit Walk(const TriangleSurface& surface) : position_(surface.points.size(), none) {
    for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> edge) {
      if (edge.size() != 1) return;
      const auto number = static_cast<std::uint32_t>(ends_.size() / 2);
      const TriangleSide& side = edge[0];
      // A hole is walked around the other way than the triangle runs.
      starts_.push_back(side.backward ? side.low() : side.high());
      ends_.push_back({side.low(), number, side.high()});
      ends_.push_back({side.high(), number, side.low()});
    });
    walked_.assign(starts_.size(), false);
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

  /// The edge that was asked for, or the first that has not been walked; of these
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
  std::vector<std::uint32_t> starts_;  ///< of each edge, as the hole runs
  std::vector<bool> walked_;
  std::vector<std::uint32_t> path_, position_;  ///< position_: of each point, in path_
  std::vector<HoleLoop> loops_;
};

/// The triangles of the least area between the points of a loop; the area of those
/// between the points i and k is the least of what any j between them leaves.
class LeastArea {
 public:
  LeastArea(const HoleLoop& loop, const std::vector<Point3>& points)
      : loop_(loop), count_(loop.size()), area_(count_ * count_, 0), middle_(count_ * count_, 0) {
    for (std::size_t width = 2; width < count_; ++width)
      for (std::size_t i = 0; i + width < count_; ++i) weigh(i, i + width, points);
  }

  void add(std::size_t i, std::size_t k, TriangleSurface& surface) const {
    if (k - i < 2) return;
    const std::size_t j = middle_[i * count_ + k];
    surface.triangles.push_back({loop_[i], loop_[j], loop_[k]});
    add(i, j, surface);
    add(j, k, surface);
  }

 private:
  void weigh(std::size_t i, std::size_t k, const std::vector<Point3>& points) {
    double least = INFINITY;
    for (std::size_t j = i + 1; j < k; ++j) {
      const double area = area_[i * count_ + j] + area_[j * count_ + k] +
                          length(area_vector(points[loop_[i]], points[loop_[j]], points[loop_[k]]));
      if (!(area < least)) continue;
      least = area;
      middle_[i * count_ + k] = j;
    }
    area_[i * count_ + k] = least;
  }

  const HoleLoop& loop_;
  std::size_t count_;
  std::vector<double> area_;
  std::vector<std::size_t> middle_;
};

void add_fan(TriangleSurface& surface, const HoleLoop& loop) {
  Point3 middle{};
  for (const std::uint32_t p : loop)
    for (std::size_t a = 0; a < 3; ++a)
      middle[a] += surface.points[p][a] / static_cast<double>(loop.size());
  const auto top = static_cast<std::uint32_t>(surface.points.size());
  surface.points.push_back(middle);
  for (std::size_t i = 0; i < loop.size(); ++i)
    surface.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], top});
}

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
  return Walk(surface).loops();
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

void close_holes(TriangleSurface& surface, const std::vector<HoleLoop>& loops) {
  constexpr std::size_t few = 64, many = 300;
  for (const HoleLoop& loop : loops) {
    if (loop.size() <= few) LeastArea(loop, surface.points).add(0, loop.size() - 1, surface);
    else if (loop.size() <= many) add_polygon(loop, surface);
    else add_fan(surface, loop);
  }
}

}  // namespace certet
