#pragma once
/// \file
/// The angles of many tetrahedra at once, in a form that compilers vectorise.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "certet/frame.hpp"
#include "certet/quality.hpp"

namespace certet::core {

inline constexpr std::size_t lanes = 64;
using Lanes = std::array<double, lanes>;

/// One tetrahedron: the edges from its first vertex to the other three.
struct Edges {
  Point3 a, b, c;
};

/// Up to 64 tetrahedra, one in each lane, and what is computed of them.
struct TetBlock {
  // Given: the edges from the first vertex, by coordinate.
  std::array<Lanes, 3> a, b, c;

  // Computed.
  Lanes six_volume;
  /// cos |cos| of the six dihedral angles.
  std::array<Lanes, 6> signed_square;
  /// The greatest and the least of the six.
  Lanes greatest, least;
  std::array<std::array<std::int32_t, lanes>, 6> cell;  ///< of AngleBins
  /// The extreme squares of four times the area of a face squared.
  Lanes least_face, greatest_face;

  void set(std::size_t lane, const Edges& edges);
  [[nodiscard]] Edges get(std::size_t lane) const;
  /// Fills the lanes from `count` on with copies of the first.
  void repeat_first(std::size_t count);
  /// All but the cells.  The same bits on every machine; on those with wider
  /// registers sooner.
  void compute();
  void find_cells();

  /// Whether what was computed of a lane neither over- nor underflowed.
  [[nodiscard]] bool in_range(std::size_t lane) const {
    return least_face[lane] > 1e-140 && greatest_face[lane] < 1e140 &&
           std::isfinite(six_volume[lane]);
  }
};

inline void TetBlock::set(std::size_t lane, const Edges& edges) {
  for (std::size_t i = 0; i < 3; ++i) {
    a[i][lane] = edges.a[i];
    b[i][lane] = edges.b[i];
    c[i][lane] = edges.c[i];
  }
}

inline Edges TetBlock::get(std::size_t lane) const {
  Edges edges;
  for (std::size_t i = 0; i < 3; ++i) {
    edges.a[i] = a[i][lane];
    edges.b[i] = b[i][lane];
    edges.c[i] = c[i][lane];
  }
  return edges;
}

/// The slow and careful way for one tetrahedron of any size and flatness.
class CarefulTet {
 public:
  explicit CarefulTet(const Edges& edges);
  /// Uses a volume that is better known than the edges tell.
  CarefulTet(const Edges& edges, double six_volume);

  [[nodiscard]] bool positive() const { return six_volume_ > 0; }
  /// cot |cot| of the six angles; the tetrahedron must be positive.
  [[nodiscard]] std::array<double, 6> signed_squared_cotangents() const;

 private:
  void scale();

  Edges edges_;        ///< scaled so that the largest coordinate is near 1
  int exponent_ = 0;   ///< of the power of two that scaled them
  double six_volume_;  ///< of the scaled edges; zero if any is not finite
};

}  // namespace certet::core
