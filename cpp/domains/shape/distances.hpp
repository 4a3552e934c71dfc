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

/// The wall around the surface on which a periodic function is 0, at least `thickness` thick:
/// divided by its steepest gradient, the function is at most the distance to that surface.
/// `Level` has the function, of angles, its greatest gradient, and the least of the two values
/// that it reaches at most on both sides.
template <class Level>
struct Wall {
  double period, thickness;
  double operator()(const Point3& p) const {
    const double turn = 2 * std::numbers::pi / period;
    const double level = Level::value(turn * p[0], turn * p[1], turn * p[2]);
    return std::abs(level) / (turn * Level::steepest) - 0.5 * thickness;
  }
  /// The thickness at which there is no gap left on one of its sides.
  [[nodiscard]] double most() const {
    return Level::reach * period / (std::numbers::pi * Level::steepest);
  }
};

/// No gradient is longer than the root of 3 (by Cauchy and Schwarz, component by component).
struct GyroidLevel {
  static constexpr double steepest = std::numbers::sqrt3, reach = 1.5;
  static double value(double x, double y, double z) {
    return std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
  }
};
using Gyroid = Wall<GyroidLevel>;

/// Schwarz' P; each component of the gradient is at most 1.
struct PrimitiveLevel {
  static constexpr double steepest = std::numbers::sqrt3, reach = 3;
  static double value(double x, double y, double z) {
    return std::cos(x) + std::cos(y) + std::cos(z);
  }
};
using Primitive = Wall<PrimitiveLevel>;

// The greatest gradients of the next three were searched for over a period, to 12 digits, and
// are taken for a millionth longer.

/// Schwarz' D.
struct DiamondLevel {
  static constexpr double steepest = 1.000001 * std::numbers::sqrt3, reach = std::numbers::sqrt2;
  static double value(double x, double y, double z) {
    return std::sin(z) * std::cos(x - y) + std::cos(z) * std::sin(x + y);
  }
};
using Diamond = Wall<DiamondLevel>;

/// Schoen's I-WP, which runs from -5 to 3.
struct IwpLevel {
  static constexpr double steepest = 1.000001 * 3 * std::numbers::sqrt3, reach = 3;
  static double value(double x, double y, double z) {
    const double a = std::cos(x), b = std::cos(y), c = std::cos(z);
    return 2 * (a * b + b * c + c * a) - (std::cos(2 * x) + std::cos(2 * y) + std::cos(2 * z));
  }
};
using Iwp = Wall<IwpLevel>;

struct NeoviusLevel {
  static constexpr double steepest = 1.000001 * 7, reach = 13;
  static double value(double x, double y, double z) {
    const double a = std::cos(x), b = std::cos(y), c = std::cos(z);
    return 3 * (a + b + c) + 4 * a * b * c;
  }
};
using Neovius = Wall<NeoviusLevel>;

/// Round bars along all edges of a grid of cubes, corners of which are at the origin and so on.
/// Of a radius of half a cell at most they fill (3 pi r^2 - 8 sqrt(2) r^3) of a cell of edge 1.
struct Struts {
  double cell, radius;
  double operator()(const Point3& p) const {
    Point3 u;
    for (std::size_t a = 0; a < 3; ++a) u[a] = p[a] - cell * std::round(p[a] / cell);
    const double xx = u[0] * u[0], yy = u[1] * u[1], zz = u[2] * u[2];
    return std::sqrt(std::min({xx + yy, yy + zz, zz + xx})) - radius;
  }
  /// The radius at which there is no gap left.
  [[nodiscard]] double most() const { return cell / std::numbers::sqrt2; }
};

/// Part of a solid: no more than the distance to its surface.
template <class Solid>
struct Within {
  Solid solid;
  Box box;
  double operator()(const Point3& p) const { return std::max(solid(p), box(p)); }
};

}  // namespace certet::shape
