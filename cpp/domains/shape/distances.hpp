#pragma once
/// \file
/// Signed distances of world points to surfaces, negative inside.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certet/bounds.hpp"
#include "certet/frame.hpp"

namespace certet::shape {

/// From distances to two perpendicular pairs of faces to that of their solid.
inline double corner(double a, double b) {
  const double out_a = std::max(a, 0.0), out_b = std::max(b, 0.0);
  return std::sqrt(out_a * out_a + out_b * out_b) + std::min(std::max(a, b), 0.0);
}

struct Sphere {
  double radius;
  double operator()(const Point3& p) const {
    return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - radius;
  }
  [[nodiscard]] Bounds bounds() const {
    return {{-radius, -radius, -radius}, {radius, radius, radius}};
  }
  [[nodiscard]] double volume() const { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }
};

/// Around z.
struct Torus {
  double ring, tube;
  double operator()(const Point3& p) const {
    const double beside = std::sqrt(p[0] * p[0] + p[1] * p[1]) - ring;
    return std::sqrt(beside * beside + p[2] * p[2]) - tube;
  }
  [[nodiscard]] Bounds bounds() const {
    return {{-ring - tube, -ring - tube, -tube}, {ring + tube, ring + tube, tube}};
  }
  [[nodiscard]] double volume() const {
    return 2 * std::numbers::pi * std::numbers::pi * ring * tube * tube;
  }
};

struct Box {
  Bounds sides;
  double operator()(const Point3& p) const {
    const auto beyond = [&](std::size_t a) {
      return std::max(sides.low[a] - p[a], p[a] - sides.high[a]);
    };
    const double a = beyond(0), b = beyond(1), c = beyond(2);
    const double out_a = std::max(a, 0.0), out_b = std::max(b, 0.0), out_c = std::max(c, 0.0);
    return std::sqrt(out_a * out_a + out_b * out_b + out_c * out_c) +
           std::min(std::max({a, b, c}), 0.0);
  }
  [[nodiscard]] Bounds bounds() const { return sides; }
  [[nodiscard]] double volume() const {
    return (sides.high[0] - sides.low[0]) * (sides.high[1] - sides.low[1]) *
           (sides.high[2] - sides.low[2]);
  }
};

/// Along z.
struct Cylinder {
  double radius, half_height;
  double operator()(const Point3& p) const {
    return corner(std::sqrt(p[0] * p[0] + p[1] * p[1]) - radius, std::abs(p[2]) - half_height);
  }
  [[nodiscard]] Bounds bounds() const {
    return {{-radius, -radius, -half_height}, {radius, radius, half_height}};
  }
  [[nodiscard]] double volume() const {
    return 2 * std::numbers::pi * radius * radius * half_height;
  }
};

/// No gradient of sin x cos y + sin y cos z + sin z cos x is longer than the root
/// of 3 (by Cauchy and Schwarz, component by component), so that divided by that
/// the function is at most the distance to the gyroid.
struct Gyroid {
  double period, thickness;
  double operator()(const Point3& p) const {
    const double turn = 2 * std::numbers::pi / period;
    const double x = turn * p[0], y = turn * p[1], z = turn * p[2];
    const double level =
        std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
    return std::abs(level) / (turn * std::numbers::sqrt3) - 0.5 * thickness;
  }
};

/// Part of a solid: no more than the distance to its surface.
template <class Solid>
struct Within {
  Solid solid;
  Box box;
  double operator()(const Point3& p) const { return std::max(solid(p), box(p)); }
};

}  // namespace certet::shape
