#pragma once
/// \file
/// The similarity transform from lattice to world coordinates.

#include <array>

#include "certet/coord3.hpp"

namespace certet {

/// A point of the world, in the input's units.
using Point3 = std::array<double, 3>;

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
};

}  // namespace certet
