#pragma once
/// \file
/// Cubes of space, two long edges wide, and what is near a line.

#include <cmath>
#include <cstdint>
#include <span>

#include "curve.hpp"

namespace certet::features {

/// A number for each cube.
using CubeKey = std::uint64_t;

inline constexpr int cube_bits = step_bits + 2;

constexpr CubeKey cube_of(Coord3 p, int i = 0, int j = 0, int k = 0) {
  const auto index = [](std::int32_t c, int by) {
    return static_cast<CubeKey>((c >> cube_bits) + by + (1 << 16)) & 0x3ffff;
  };
  return (index(p.x, i) << 36) | (index(p.y, j) << 18) | index(p.z, k);
}

/// Calls visit(key) for the cube of a position and those around.
template <class Visit>
void visit_around(Coord3 p, const Visit& visit) {
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) visit(cube_of(p, i, j, k));
}

/// The same for all cubes that a line passes, each several times.
template <class Visit>
void visit_along(const Vector& from, const Vector& to, const Visit& visit) {
  const Vector by = to - from;
  const double parts = std::ceil(length(by) / (1 << (cube_bits - 1))) + 1;
  for (double i = 0; i <= parts; ++i) visit_around(in_steps(from + (i / parts) * by), visit);
}

}  // namespace certet::features
