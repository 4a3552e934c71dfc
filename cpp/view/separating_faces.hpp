#pragma once
/// \file
/// The triangles to be seen when a mesh is cut open: those between tetrahedra
/// on different sides of a plane, and those with nothing behind.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "certet/formats.hpp"

namespace certet::view {

inline constexpr std::uint64_t no_tet = std::numeric_limits<std::uint64_t>::max();

/// A triangle that `tet` sees turning left from outside, and what is behind it.
struct SeparatingFace {
  std::array<std::uint64_t, 3> points;
  std::uint64_t tet;
  std::uint64_t other;  ///< `no_tet` at the border of the mesh
};

/// Parallel planes at equal distances across each axis of a box.  A tetrahedron
/// lies on one side of each, by its centroid: it is never cut itself.
class Planes {
 public:
  static constexpr int most = 120;

  /// No planes.
  Planes() = default;
  /// `count[axis]` planes between `low` and `high`, the gaps at the ends being as
  /// wide as the others; at most 120 for each axis.
  Planes(const Point3& low, const Point3& high, const std::array<int, 3>& count);
  /// One plane.
  static Planes single(int axis, double place);

  [[nodiscard]] int count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] double place(int axis, int plane) const;
  /// How many planes of each axis a point has behind it.
  using Sides = std::array<std::uint8_t, 3>;
  [[nodiscard]] Sides sides(const Point3& centroid) const;

 private:
  std::array<int, 3> count_{};
  Point3 first_{}, per_length_{}, gap_{};
};

inline Planes::Sides Planes::sides(const Point3& centroid) const {
  Sides sides{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double behind = centroid[axis] - first_[axis];
    if (count_[axis] == 0 || behind < 0) continue;
    const double planes = std::floor(behind * per_length_[axis]) + 1;
    // Not a number where the planes are at one place.
    sides[axis] = static_cast<std::uint8_t>(planes < count_[axis] ? planes : count_[axis]);
  }
  return sides;
}

/// The sides of a tetrahedron's centroid.
inline Planes::Sides sides_of(const FileMesh& mesh, std::uint64_t tet, const Planes& planes) {
  Point3 centroid{};
  for (const std::uint64_t corner : mesh.tets[tet])
    for (std::size_t axis = 0; axis < 3; ++axis) centroid[axis] += mesh.points[corner][axis] / 4;
  return planes.sides(centroid);
}

/// Whether faces between tetrahedra of different labels are among those found.
enum class BetweenLabels { passed_over, found };

/// All faces at the border, and those between tetrahedra that a plane separates, or their
/// labels; ordered by their points.  Tetrahedra without four corners are left out.
///
/// Takes 8 bytes for each point, and for each of the faces near a plane or the
/// border 24 bytes.
std::vector<SeparatingFace> separating_faces(
    const FileMesh& mesh, const Planes& planes,
    BetweenLabels between = BetweenLabels::passed_over);

/// Whether a face lies between two labels.
inline bool is_between_labels(const FileMesh& mesh, const SeparatingFace& face) {
  return face.other != no_tet && !mesh.labels.empty() &&
         mesh.labels[face.tet] != mesh.labels[face.other];
}

}  // namespace certet::view
