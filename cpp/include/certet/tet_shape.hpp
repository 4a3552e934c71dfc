#pragma once
/// \file
/// The shape of a tetrahedron, and of all tetrahedra of a mesh: aspect and
/// lengths of edges.  Angles and volumes in bulk are in quality.hpp.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "certet/mesh.hpp"

namespace certet {

/// The aspect of a tetrahedron is its longest edge over its shortest altitude:
/// sqrt(3/2) = 1.2247 if it is regular, sqrt(2) in the lattice, without end as
/// it grows flat.
struct TetShape {
  double least_dihedral, greatest_dihedral;  ///< degrees; NaN where it is flat
  double aspect;                             ///< infinite where it is flat
  double shortest_edge, longest_edge;

  /// How far its angles keep from 0° and from 180°, in degrees: the least
  /// dihedral angle, or 180° less the greatest; 70.53° at most.
  [[nodiscard]] double worst_angle() const;
};

/// Of a tetrahedron with these corners, whichever way it is turned.
TetShape shape_of(const std::array<Point3, 4>& corners);

/// What the shapes of a mesh are like.
struct ShapeSurvey {
  /// Aspects below 1 + (i + 1)/4, the last bin takes all above.
  static constexpr int aspect_bins = 61;
  static constexpr double aspect_step = 0.25;
  /// Bins of the same width from the shortest edge to the longest.
  static constexpr int edge_bins = 40;

  std::uint64_t tets = 0;  ///< with four corners (has_corners); the others are left out
  double greatest_aspect = 0;
  double shortest_edge = 0, longest_edge = 0;
  std::array<std::uint64_t, aspect_bins> aspects{};
  /// Every edge as often as there are tetrahedra that have it.
  std::array<std::uint64_t, edge_bins> edges{};
};

/// Tetrahedra with an index that is not a point's, or with a corner that is nowhere,
/// are left out.
ShapeSurvey survey_shapes(std::span<const Point3> points,
                          std::span<const Tet<std::uint64_t>> tets);

/// Whether all four indices are those of points, and the points somewhere: neither NaN nor
/// beyond 1e50, where no lattice reaches, so that areas and volumes are finite numbers, and
/// their squares.
inline bool has_corners(std::span<const Point3> points, const Tet<std::uint64_t>& tet) {
  for (const std::uint64_t corner : tet) {
    if (corner >= points.size()) return false;
    for (const double coordinate : points[corner])
      if (!(std::fabs(coordinate) <= 1e50)) return false;
  }
  return true;
}

}  // namespace certet
