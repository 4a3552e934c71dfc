#include "mover.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/optimise/descent.hpp"

namespace certet::features {
namespace {

/// In long edges, from where stuffing put it.
constexpr double greatest_reach = 2;
/// In squared cosines.
constexpr double least_gain = 5e-4;
constexpr std::array<double, 3> bands{0.08, 0.02, 0.005};

}  // namespace

double squared_cosine(double degrees) {
  const double cosine = std::cos(degrees * (std::numbers::pi / 180));
  return cosine * cosine;
}

bool Mover::is_near(Number v, Coord3 place) const {
  return length(between(zone_.origin(v), place)) <= greatest_reach * long_edge;
}

bool Mover::put(Number v, Coord3 place, const AngleLimits& limits) {
  if (place == zone_.place(v) || !is_near(v, place) || !guard_.allows(v, place, limits))
    return false;
  zone_.put(v, place);
  return true;
}

bool Mover::push(Number v, Coord3 target) {
  if (put(v, target, push_limits_)) return true;
  const Vector own = in_doubles(zone_.place(v)), by = between(zone_.place(v), target);
  constexpr double least_share = 0.05;
  for (double share = 0.5; share > least_share; share /= 2)
    if (put(v, sites_.onto(sites_[v], own + share * by), push_limits_)) return true;
  return false;
}

void Mover::load(Number v) {
  star_.clear();
  for (const StarTet at : zone_.around(v)) {
    star_.add(at.tet(), guard_.corners_of(at.tet()), at.corner(), 0);
    star_.measure_last();
  }
}

bool Mover::relax(Number v, double aim) {
  if (sites_[v].role == Role::fixed || !zone_.is_free(v)) return false;
  load(v);
  const double worst = star_.worst();
  return worst > aim && descend(v, worst);
}

bool Mover::descend(Number v, double worst) {
  const Vector own = in_doubles(zone_.place(v));
  const double bar = worst - least_gain;
  const optimising::Bars bars{bar, bar};
  for (const double band : bands) {
    gradients_.clear();
    for (const optimising::Spoke& spoke : star_.spokes())
      if (spoke.worst >= worst - band) spoke.gradients(worst - band, gradients_);
    for (Vector& gradient : gradients_) gradient = sites_.part_of(sites_[v], gradient, own);
    if (gradients_.empty()) continue;
    const Vector shortest = optimising::shortest_in_hull(gradients_);
    const double slope = length(shortest);
    if (!(slope * (long_edge / 4) > least_gain)) continue;
    const double farthest = std::min(band / slope, long_edge / 4);
    for (double far = farthest; far > farthest / 10; far /= 2) {
      const Coord3 place = sites_.onto(sites_[v], own + (-far / slope) * shortest);
      if (star_.keeps(between(zone_.place(v), place), bars) && put(v, place, limits_))
        return true;
    }
  }
  return false;
}

}  // namespace certet::features
