#pragma once
/// \file
/// Vectors in single precision, for drawing.

#include <algorithm>
#include <array>
#include <cmath>

#include "certet/frame.hpp"

namespace certet::view {

struct Vec {
  float x = 0, y = 0, z = 0;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(float s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Of length one; the zero vector stays.
inline Vec unit(Vec a) {
  const float length = std::sqrt(dot(a, a));
  return length > 0 ? 1 / length * a : a;
}

/// What is smaller is not shown; lattices have edges of 1e-30 at least.
inline constexpr double least_seen = 1e-50;

/// Two opposite corners of a box along the axes.
struct Box {
  Point3 low, high;
  [[nodiscard]] double width() const {
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }
};

}  // namespace certet::view
