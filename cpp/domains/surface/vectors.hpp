#pragma once
/// \file
/// Arithmetic on points of the world, rounded as double precision is.

#include <cmath>

#include "certet/frame.hpp"

namespace certet {

inline Point3 difference(const Point3& to, const Point3& from) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// The point a share of the way from one to the other.
inline Point3 between(const Point3& from, const Point3& to, double share) {
  return {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]),
          from[2] + share * (to[2] - from[2])};
}

inline double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Point3& a) { return std::hypot(a[0], a[1], a[2]); }

inline double distance(const Point3& a, const Point3& b) { return length(difference(a, b)); }

/// Twice the area vector of a triangle.
inline Point3 area_vector(const Point3& a, const Point3& b, const Point3& c) {
  return cross(difference(b, a), difference(c, a));
}

}  // namespace certet
