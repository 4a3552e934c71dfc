#pragma once
/// \file
/// On which side of a triangle a point lies, exactly.

#include <cstdint>

#include "certet/lattice/coord3.hpp"

namespace certet {

/// det(b-a, c-a, d-a): six times the signed volume, in steps cubed.  Exact if no
/// edge from `a` is longer than 2^19 steps along an axis (`VolumesFit` of the
/// certificate), or than 2^20 (`GradedVolumesFit`); those of the output and of the
/// warped lattice are at most 2^18 long (`TetsNarrow`), those of graded meshes 2^20.
constexpr std::int64_t six_volume(Coord3 a, Coord3 b, Coord3 c, Coord3 d) {
  const auto x = [&](Coord3 p) { return std::int64_t{p.x} - a.x; };
  const auto y = [&](Coord3 p) { return std::int64_t{p.y} - a.y; };
  const auto z = [&](Coord3 p) { return std::int64_t{p.z} - a.z; };
  return x(b) * (y(c) * z(d) - z(c) * y(d)) - y(b) * (x(c) * z(d) - z(c) * x(d)) +
         z(b) * (x(c) * y(d) - y(c) * x(d));
}

}  // namespace certet
