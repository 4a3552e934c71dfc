#pragma once
/// \file
/// On which side of a triangle a point lies, exactly.

#include <cstdint>

#include "certet/coord3.hpp"

namespace certet {

/// det(b-a, c-a, d-a): six times the signed volume, in steps cubed.  Exact for
/// tetrahedra of the output: their edges are shorter than 2^19 steps along each
/// axis, so that every product stays below 2^60.
constexpr std::int64_t six_volume(Coord3 a, Coord3 b, Coord3 c, Coord3 d) {
  const auto x = [&](Coord3 p) { return std::int64_t{p.x} - a.x; };
  const auto y = [&](Coord3 p) { return std::int64_t{p.y} - a.y; };
  const auto z = [&](Coord3 p) { return std::int64_t{p.z} - a.z; };
  return x(b) * (y(c) * z(d) - z(c) * y(d)) - y(b) * (x(c) * z(d) - z(c) * x(d)) +
         z(b) * (x(c) * y(d) - y(c) * x(d));
}

}  // namespace certet
