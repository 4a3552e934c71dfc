#include "chords.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "exact.hpp"
#include "rounding.hpp"
#include "triangle_columns.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

/// Lines across the box, along each of its two other axes.
constexpr std::int64_t lines_across = 144;

/// Where a line leaves the solid or enters it.
struct Crossing {
  double x;
  int direction;    ///< 1 if it leaves, as x grows
  Point3 normal;    ///< of length 1, towards greater x
};

/// Lines along one axis, which is x here.
class ParallelLines {
 public:
  ParallelLines(std::vector<Coord3> points, const TriangleSurface& surface, Rule rule)
      : inside_(surface, points, rule), low_(points[surface.triangles[0][0]]), high_(low_),
        columns_(std::move(points), surface.triangles) {
    for (std::uint32_t t = 0; t < columns_.size(); ++t)
      for (const Coord3 c : columns_.corners(t)) {
        low_ = {std::min(low_.x, c.x), std::min(low_.y, c.y), std::min(low_.z, c.z)};
        high_ = {std::max(high_.x, c.x), std::max(high_.y, c.y), std::max(high_.z, c.z)};
      }
  }

  void find(double step, Chords& chords, const Context& context) {
    const double y = static_cast<double>(exact::gap(low_.y, high_.y)) / lines_across,
                 z = static_cast<double>(exact::gap(low_.z, high_.z)) / lines_across;
    area_ = y * z * step * step;
    step_ = step;
    for (std::int64_t k = 0; k < lines_across; ++k) {
      stop_if_cancelled(context);
      for (std::int64_t j = 0; j < lines_across; ++j)
        follow({low_.x, at(low_.y, y, j), at(low_.z, z, k)}, chords);
    }
  }

 private:
  static std::int32_t at(std::int32_t low, double width, std::int64_t line) {
    return static_cast<std::int32_t>(static_cast<double>(low) +
                                     (static_cast<double>(line) + 0.5) * width);
  }

  void follow(Coord3 from, Chords& chords) {
    crossings_.clear();
    columns_.for_each_ahead(from, [&](const exact::Corners& t) {
      const int direction = exact::passing(t, from, exact::Nudge::forward);
      if (direction == 0) return;
      const exact::Normal n = exact::normal(t);
      const double nx = static_cast<double>(n.x);
      const double length = std::hypot(nx, static_cast<double>(n.y), static_cast<double>(n.z));
      const double unit = (nx > 0 ? 1 : -1) / length;
      crossings_.push_back({-static_cast<double>(exact::height(t, n, from)) / nx, direction,
                            {nx * unit, static_cast<double>(n.y) * unit,
                             static_cast<double>(n.z) * unit}});
    });
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.x > b.x; });
    measure(from, chords);
  }

  void measure(Coord3 from, Chords& chords) const {
    int winding = 0;
    const Crossing* end = nullptr;
    bool before = false, now = false;
    for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
      const Crossing &one = crossings_[i], &next = crossings_[i + 1];
      winding += one.direction;
      now = i == 0 ? inside(winding, from, i) : now;
      const bool after = inside(winding + next.direction, from, i + 1);
      if (now && !before) end = &one;
      before = std::exchange(now, after);
      if (!before) continue;
      chords.inside += (one.x - next.x) * step_ * area_;
      chords.wound += winding * ((one.x - next.x) * step_ * area_);
      if (after) continue;
      // Near a sharp edge a line meets the two faces there, which are no wall.
      constexpr double least_facing = 0.85;
      if (dot(end->normal, next.normal) < least_facing) continue;
      add(*end, (end->x - next.x) * step_, chords);
      add(next, (end->x - next.x) * step_, chords);
    }
  }

  /// Only where the line is nearer to the normal than those along other axes.
  void add(const Crossing& crossing, double length, Chords& chords) const {
    constexpr double least_steepness = 0.577;
    constexpr double least_steps = 100;
    const double steepness = crossing.normal[0];
    if (steepness < least_steepness || length < least_steps * step_) return;
    chords.behind.push_back({length * steepness, area_ / steepness});
  }

  /// Between a crossing and the next one.
  [[nodiscard]] bool inside(int winding, Coord3 from, std::size_t crossing) const {
    if (crossing + 1 >= crossings_.size()) return false;
    const double middle = (crossings_[crossing].x + crossings_[crossing + 1].x) / 2;
    from.x = static_cast<std::int32_t>(static_cast<double>(from.x) + middle);
    return inside_.at(winding, from, exact::Nudge::forward) == Sign::plus;
  }

  Inside inside_;
  Coord3 low_, high_;
  TriangleColumns columns_;
  double area_ = 0, step_ = 0;
  std::vector<Crossing> crossings_;
};

}  // namespace

Chords find_chords(const TriangleSurface& surface, Rule rule, const Context& context) {
  const Rounding round(surface);
  Chords chords;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Coord3> points(surface.points.size(), Coord3{0, 0, 0});
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t p : triangle) {
        const Coord3 c = round(surface.points[p]);
        points[p] = axis == 0 ? c : axis == 1 ? Coord3{c.y, c.z, c.x} : Coord3{c.z, c.x, c.y};
      }
    ParallelLines(std::move(points), surface, rule).find(round.step(), chords, context);
  }
  return chords;
}

}  // namespace certet
