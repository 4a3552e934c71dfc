#include "ball.hpp"

#include <algorithm>
#include <cmath>

#include "vectors.hpp"

namespace certet::distance {
namespace {

constexpr double step = 1.0 / steps;
/// The radii of a ball that grows: most points of a surface are on it.
constexpr double first_radius = 2 * step, second_radius = 1.0 / 64, last_radius = 2;
/// Radii and directions are found to these parts, but for the last bisection.
constexpr double near_enough = 1.0 / 256, least_aside = 1.0 / 32, closer = 0.6;

/// Along the edges of the lattice.
constexpr double d = 0.57735026918962576451;
constexpr std::array<Point3, 14> around{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1},
                                         {0, 0, -1}, {d, d, d}, {d, d, -d}, {d, -d, d}, {d, -d, -d},
                                         {-d, d, d}, {-d, d, -d}, {-d, -d, d}, {-d, -d, -d}}};

/// The corners of two hexagons around a direction, which take turns: where the surface has a corner,
/// what is nearer may lie between those of one.
constexpr double s = 0.86602540378443864676;
constexpr std::array<std::array<std::array<double, 2>, 6>, 2> hexagons{
    {{{{1, 0}, {0.5, s}, {-0.5, s}, {-1, 0}, {-0.5, -s}, {0.5, -s}}},
     {{{s, 0.5}, {0, 1}, {-s, 0.5}, {-s, -0.5}, {0, -1}, {s, -0.5}}}}};

/// Two directions at right angles to one and to each other.
std::array<Point3, 2> across(const Point3& direction) {
  std::size_t least = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (std::abs(direction[a]) < std::abs(direction[least])) least = a;
  Point3 axis{0, 0, 0};
  axis[least] = 1;
  const Point3 one = unit(cross(direction, axis));
  return {one, cross(direction, one)};
}

}  // namespace

Ball::Probes Ball::probes() const {
  Probes probes = best_;
  switch (stage_) {
    case Stage::start: probes.add({0, 0, 0}); break;
    case Stage::grow:
      for (const Point3& direction : around) probes.add(direction);
      probes.radius = outer_;
      break;
    case Stage::turn: {
      const Point3 direction = best_.directions[0];
      const auto [u, v] = across(direction);
      probes.count = 0;
      for (const auto& [x, y] : hexagons[turns_ % 2])
        probes.add(unit(sum(direction, scaled(aside_, sum(scaled(x, u), scaled(y, v))))));
      probes.radius = outer_ - std::max(outer_ * near_enough, step);
      break;
    }
    default: probes.radius = middle();
  }
  return probes;
}

void Ball::add_probes(Question& question) const {
  const Probes asked = probes();
  for (std::size_t i = 0; i < asked.count; ++i)
    question.add(sum(centre_, scaled(asked.radius, asked.directions[i])));
}

void Ball::take(const Question& question, std::size_t first) {
  const Probes asked = probes();
  if (stage_ == Stage::start) {
    own_ = question[first];
    outer_ = first_radius;
    stage_ = Stage::grow;
    return;
  }
  Probes changed;
  changed.radius = asked.radius;
  for (std::size_t i = 0; i < asked.count; ++i)
    if (question[first + i] != own_) changed.add(asked.directions[i]);
  switch (stage_) {
    case Stage::grow: return grow(changed);
    case Stage::turn: return turn(changed);
    default: return shrink(changed);
  }
}

void Ball::grow(const Probes& changed) {
  if (changed.count > 0) {
    best_ = changed;
    stage_ = Stage::shrink;
    return;
  }
  inner_ = outer_;
  outer_ = std::max(2 * outer_, second_radius);
  if (outer_ > last_radius) stage_ = Stage::far;
}

void Ball::shrink(const Probes& changed) {
  (changed.count > 0 ? outer_ : inner_) = changed.radius;
  if (changed.count > 0) best_ = changed;
  const bool settling = stage_ == Stage::settle;
  if (outer_ - inner_ > std::max(step, settling ? 0 : outer_ * near_enough)) return;
  best_.count = 1;
  stage_ = settling || outer_ <= first_radius ? Stage::found : Stage::turn;
}

void Ball::turn(const Probes& changed) {
  if (changed.count > 0) {
    best_ = changed;
    outer_ = changed.radius;
    inner_ = outer_ / 2;  // in this direction nothing is known
    stage_ = Stage::shrink;
    return;
  }
  ++turns_;
  aside_ *= closer;
  if (aside_ < least_aside) stage_ = Stage::settle;
}

void Ball::reach(const Point3& place) {
  const Point3 way = difference(place, centre_);
  outer_ = length(way);
  inner_ = outer_ / 2;
  best_.count = 0;
  best_.add(unit(way));
  stage_ = Stage::turn;
}

}  // namespace certet::distance
