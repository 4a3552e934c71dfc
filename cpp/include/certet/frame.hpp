#pragma once
/// \file
/// The similarity transform from lattice to world coordinates.

#include <algorithm>
#include <array>
#include <cmath>

#include "certet/lattice/coord3.hpp"

namespace certet {

/// A point of the world, in the input's units.
using Point3 = std::array<double, 3>;

inline bool is_finite(const Point3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// world = origin + (size / 2) * axes * lattice.  `axes` is a rotation (row
/// major, right-handed), `size` the length of a long edge in world units.
struct Frame {
  Point3 origin{0, 0, 0};
  std::array<std::array<double, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double size = 1;

  /// The world point of a position given in steps.
  [[nodiscard]] Point3 world(Coord3 position) const {
    const double unit = size / (2.0 * steps);
    const double x = unit * position.x;
    const double y = unit * position.y;
    const double z = unit * position.z;
    return {origin[0] + (axes[0][0] * x + axes[0][1] * y + axes[0][2] * z),
            origin[1] + (axes[1][0] * x + axes[1][1] * y + axes[1][2] * z),
            origin[2] + (axes[2][0] * x + axes[2][1] * y + axes[2][2] * z)};
  }

  /// The position of a world point, in lattice units: what `world` turns round, but for rounding.
  [[nodiscard]] Point3 position(const Point3& world) const {
    Point3 at{};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t r = 0; r < 3; ++r) at[a] += (world[r] - origin[r]) * axes[r][a];
      at[a] *= 2 / size;
    }
    return at;
  }

  /// The world point of a position given in lattice units.
  [[nodiscard]] Point3 world_at(const Point3& position) const {
    Point3 place = origin;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t a = 0; a < 3; ++a) place[r] += axes[r][a] * position[a] * (size / 2);
    return place;
  }

  /// How far `world` may move a coordinate by rounding, in long edges; for
  /// positions whose coordinates are at most `reach` lattice units.  Each
  /// coordinate is a sum of three products and the origin: with u = 2^-53, three
  /// products of three factors come within 2u of each, their sum within 2u more,
  /// and the last addition within u of the result.
  [[nodiscard]] double rounding(std::int32_t reach) const {
    const double farthest = std::max({std::fabs(origin[0]), std::fabs(origin[1]),
                                      std::fabs(origin[2])});
    return std::ldexp(farthest / size + 16 * (0.5 * reach), -53);
  }

  /// How far `axes` are from orthonormal: the greatest magnitude of an element of
  /// axesᵀ axes - 1.  Not a number where one of them is none.
  [[nodiscard]] double skew() const {
    double greatest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        double dot = 0;
        for (std::size_t r = 0; r < 3; ++r) dot += axes[r][a] * axes[r][b];
        const double off = std::fabs(dot - (a == b ? 1 : 0));
        if (std::isnan(off)) return off;
        greatest = std::max(greatest, off);
      }
    return greatest;
  }

  /// Whether `axes` are orthonormal but for `tolerance`.
  [[nodiscard]] bool is_rotation(double tolerance) const { return skew() <= tolerance; }
};

}  // namespace certet
