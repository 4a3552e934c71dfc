#pragma once
/// \file
/// Arithmetic of points.

#include <cmath>

#include "certet/frame.hpp"

namespace certet::distance {

/// A position in lattice units.
inline Point3 in_units(Coord3 position) {
  constexpr double unit = 1.0 / steps;
  return {unit * position.x, unit * position.y, unit * position.z};
}
inline Point3 sum(const Point3& a, const Point3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point3 scaled(double factor, const Point3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }
/// Of a vector that is not 0.
inline Point3 unit(const Point3& a) { return scaled(1 / length(a), a); }
inline Point3 between(const Point3& a, const Point3& b, double share) {
  return sum(a, scaled(share, difference(b, a)));
}
inline Point3 centroid(const Point3& a, const Point3& b, const Point3& c) {
  return scaled(1.0 / 3, sum(a, sum(b, c)));
}
/// Twice the area, as long as that and at right angles to it.
inline Point3 normal(const Point3& a, const Point3& b, const Point3& c) {
  return cross(difference(b, a), difference(c, a));
}

}  // namespace certet::distance
