#pragma once
/// \file
/// Vectors in steps, in doubles that hold the differences of positions exactly.

#include <array>
#include <cmath>

#include "certet/lattice/coord3.hpp"

namespace certet::optimising {

using Vector = std::array<double, 3>;

constexpr Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
constexpr Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
constexpr Vector operator*(double t, const Vector& a) { return {t * a[0], t * a[1], t * a[2]}; }
constexpr double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// From one position to another.
constexpr Vector between(Coord3 from, Coord3 to) {
  const Coord3 by = to - from;
  return {static_cast<double>(by.x), static_cast<double>(by.y), static_cast<double>(by.z)};
}

/// The nearest position to one that is so far from another.
inline Coord3 moved(Coord3 from, const Vector& by) {
  const auto whole = [](double c) { return static_cast<std::int32_t>(std::floor(c + 0.5)); };
  return from + Coord3{whole(by[0]), whole(by[1]), whole(by[2])};
}

}  // namespace certet::optimising
