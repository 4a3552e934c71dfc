#pragma once
/// \file
/// Whether a tetrahedron keeps the bounds of the angles, in integers.

#include <array>
#include <cstdint>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/orientation.hpp"

namespace certet {

/// The square of a cotangent, as a fraction.
struct SquaredCotangent {
  std::int32_t numerator, denominator;
};

/// Of 10.77 and of 164.76 degrees, rounded so that the angles are wider: the bounds of
/// `SettledMeshHasItAll`.
inline constexpr SquaredCotangent least_angle{221, 8};
inline constexpr SquaredCotangent greatest_angle{1751, 130};

/// Between which all dihedral angles of a tetrahedron are to be.
struct AngleLimits {
  SquaredCotangent least, greatest;
};

/// Whether a tetrahedron, positions in steps, has a positive volume and all dihedral angles
/// within the limits, exactly.  No coordinates differ by 2^19 steps or more, numerators are less than
/// 2^12 and denominators at most 130: then no number has more than 127 bits, the greatest being
/// denominator * rest^2, with rest less than a volume of at most 2^59.4.
constexpr bool keeps_limits(const std::array<Coord3, 4>& p, const AngleLimits& limits) {
  __extension__ using Wide = __int128;
  struct Vector {
    std::int64_t x, y, z;
  };
  const auto from = [](Coord3 a, Coord3 b) {
    return Vector{std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const auto dot = [](const Vector& a, const Vector& b) {
    return Wide{a.x} * b.x + Wide{a.y} * b.y + Wide{a.z} * b.z;
  };
  const std::int64_t volume = six_volume(p[0], p[1], p[2], p[3]);
  if (volume <= 0) return false;
  constexpr std::array<std::array<std::uint8_t, 4>, 6> edges{
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  for (const auto& [a, b, c, d] : edges) {
    const Vector edge = from(p[a], p[b]);
    // The cotangent is this over the volume and the length of the edge.
    const Wide product = dot(cross(edge, from(p[a], p[c])), cross(edge, from(p[a], p[d])));
    const auto [numerator, denominator] = product > 0 ? limits.least : limits.greatest;
    // den product^2 <= num volume^2 edge^2, and no number has more than 127 bits: with
    // product = quotient volume + rest it is
    // 2 den quotient rest + den rest^2 / volume <= (num edge^2 - den quotient^2) volume.
    const Wide size = product > 0 ? product : -product;
    const Wide quotient = size / volume;
    const Wide rest = size % volume;
    if (quotient >> 24 != 0) return false;
    const Wide room = numerator * dot(edge, edge) - denominator * quotient * quotient;
    const Wide of_rest = (denominator * rest * rest + volume - 1) / volume;
    if (2 * denominator * quotient * rest + of_rest > room * volume) return false;
  }
  return true;
}

/// Whether a tetrahedron, positions in steps, has a positive volume and all dihedral
/// angles within the bounds: `IsWellShaped` of the certificate, exactly.  No coordinates
/// differ by 2^18 steps or more.
constexpr bool is_well_shaped(const std::array<Coord3, 4>& p) {
  return keeps_limits(p, {least_angle, greatest_angle});
}

}  // namespace certet
