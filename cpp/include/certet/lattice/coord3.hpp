#pragma once
/// \file
/// Integer points of the body-centred cubic lattice (section 3.1 of the paper).

#include <compare>
#include <cstdint>

namespace certet {

/// A lattice point, in lattice units (half of a long edge), or a position, in
/// steps (lattice units times `steps`); each use says which.
struct Coord3 {
  std::int32_t x, y, z;
  friend constexpr bool operator==(const Coord3&, const Coord3&) = default;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the comparison with 0 for a pointer's
  friend constexpr auto operator<=>(const Coord3&, const Coord3&) = default;
};

constexpr Coord3 operator+(Coord3 a, Coord3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Coord3 operator-(Coord3 a, Coord3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Coord3 operator*(std::int32_t n, Coord3 a) {
  return {n * a.x, n * a.y, n * a.z};
}

/// Every edge of the lattice is divided in 2^step_bits steps; the surface is
/// found to one step.  `StepBits` of the certificate.
inline constexpr int step_bits = 16;
inline constexpr std::int32_t steps = std::int32_t{1} << step_bits;

/// A lattice point in use has all coordinates in [-coordinate_limit,
/// coordinate_limit], so that its position in steps fits 32 bits (`WarpedFits`,
/// `CutFits`, `MiddleFits` of the certificate).
inline constexpr std::int32_t coordinate_limit = 32'000;

}  // namespace certet
