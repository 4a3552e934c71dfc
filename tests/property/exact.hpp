#pragma once
/// \file
/// Measuring tetrahedra without trusting the library: volumes exactly, dihedral
/// angles by exact products and one comparison with a stated margin.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "certet/lattice/coord3.hpp"

namespace exact {

__extension__ using Wide = __int128;

struct Vector {
  Wide x, y, z;
};

/// From a to b.
constexpr Vector between(certet::Coord3 a, certet::Coord3 b) {
  return {Wide{b.x} - a.x, Wide{b.y} - a.y, Wide{b.z} - a.z};
}
constexpr Wide dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Tet = std::array<certet::Coord3, 4>;

/// det(b-a, c-a, d-a), exact.
constexpr Wide six_volume(const Tet& t) {
  return dot(cross(between(t[0], t[1]), between(t[0], t[2])), between(t[0], t[3]));
}

/// The cotangent of the dihedral angle at edge ab of a tetrahedron abcd of
/// positive volume is N / (V |b-a|).
struct Dihedral {
  Wide n, volume, edge_squared;

  [[nodiscard]] long double degrees() const {
    return std::atan2(static_cast<long double>(volume) *
                          std::sqrt(static_cast<long double>(edge_squared)),
                      static_cast<long double>(n)) *
           180 / std::numbers::pi_v<long double>;
  }
};

/// The six dihedral angles.
inline std::array<Dihedral, 6> dihedrals(const Tet& t) {
  constexpr int edges[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                               {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};
  std::array<Dihedral, 6> angles;
  const Wide volume = six_volume(t);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto at = [&](int k) { return t[static_cast<std::size_t>(edges[i][k])]; };
    const Vector edge = between(at(0), at(1));
    const Vector n1 = cross(edge, between(at(0), at(2)));
    const Vector n2 = cross(edge, between(at(0), at(3)));
    angles[i] = {dot(n1, n2), volume, dot(edge, edge)};
  }
  return angles;
}

/// A closed range of angles, in degrees.
class AngleRange {
 public:
  AngleRange(double low, double high)
      : low_cot_squared_(cot_squared(low)), high_cot_squared_(cot_squared(high)) {}

  /// Whether an angle is in the range.  N, V and the edge are exact, so that
  /// rounding is below 1e-17 of either side; the bounds are narrowed by 1e-15,
  /// which makes `true` certain.
  [[nodiscard]] bool contains(const Dihedral& angle) const {
    const auto n = static_cast<long double>(angle.n);
    const auto v = static_cast<long double>(angle.volume);
    const auto unit = v * v * static_cast<long double>(angle.edge_squared);
    const long double bound = angle.n > 0 ? low_cot_squared_ : high_cot_squared_;
    return angle.volume > 0 && n * n <= bound * unit;
  }

 private:
  static long double cot_squared(double degrees) {
    const long double t =
        std::tan(static_cast<long double>(degrees) * std::numbers::pi_v<long double> / 180);
    return (1 - 1e-15L) / (t * t);
  }
  long double low_cot_squared_, high_cot_squared_;
};

/// What is proved for the thresholds 73/256, 102/256 and 64/256, 105/256.
inline const AngleRange angles_range{10.77, 164.76};
inline const AngleRange embedding_range{9.27, 161.46};
/// And for 64/256, 95/256 where diagonals follow the cuts.
inline const AngleRange key_range{11.18, 157.13};
/// With cuts in the middle the bounds are attained, and `contains` is a little narrower.
inline const AngleRange midpoint_range{30 - 1e-9, 135 + 1e-9};

}  // namespace exact
