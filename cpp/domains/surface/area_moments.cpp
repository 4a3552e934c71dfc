#include "area_moments.hpp"

#include <cmath>

namespace certet {

AreaMoments::AreaMoments(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 twice = area_vector(a, b, c);
  area_ = std::sqrt(dot(twice, twice)) / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    vector_[i] = twice[i] / 2;
    centre_[i] = (a[i] + b[i] + c[i]) / 3;
  }
  for (const Point3& corner : {a, b, c}) {
    const Point3 from_centre = difference(corner, centre_);
    spread_.add(from_centre, from_centre, area_ / 12);
  }
}

AreaMoments AreaMoments::with(const AreaMoments& other) const {
  if (area_ == 0) return other;
  if (other.area_ == 0) return *this;
  AreaMoments both;
  both.centre_ = between(centre_, other.centre_, other.area_ / (area_ + other.area_));
  both.add(*this);
  both.add(other);
  return both;
}

void AreaMoments::add(const AreaMoments& part) {
  const Point3 place = difference(part.centre_, centre_);
  area_ += part.area_;
  for (std::size_t i = 0; i < 3; ++i) vector_[i] += part.vector_[i];
  tilt_.add(part.tilt_);
  tilt_.add(part.vector_, place, 1);
  spread_.add(part.spread_);
  spread_.add(place, place, part.area_);
}

double AreaMoments::solid_angle(const Point3& away) const {
  if (area_ == 0) return 0;
  const double square = dot(away, away), facing = dot(vector_, away);
  const Point3 tilted = tilt_.times(away), spread = spread_.times(away);
  const double first = tilt_.trace() - 3 * dot(away, tilted) / square;
  const double second = 7.5 * facing * dot(away, spread) / square -
                        1.5 * (2 * dot(vector_, spread) + spread_.trace() * facing);
  return (facing + first + second / (area_ * square)) / (square * std::sqrt(square));
}

}  // namespace certet
