#pragma once
/// \file
/// A mesh cut by a plane: a polygon of each tetrahedron that it goes through.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/formats.hpp"

namespace certet::view {

/// A plane across an axis, and on which side of it the mesh is kept.
struct CutPlane {
  int axis = 0;
  double place = 0;
  bool keeps_below = true;

  /// How far a point is behind the plane, on the side that is taken away; 0 is taken away.
  [[nodiscard]] double behind(const Point3& point) const {
    const double above = point[static_cast<std::size_t>(axis)] - place;
    return keeps_below ? above : -above;
  }
  [[nodiscard]] bool keeps(const Point3& point) const { return behind(point) < 0; }
  /// Where an edge from a point that is kept to one that is not goes through.
  [[nodiscard]] Point3 crossing(const Point3& kept, const Point3& gone) const;
};

/// What a plane cuts out of a tetrahedron: three or four corners around it.
struct SectionPolygon {
  std::uint64_t tet;
  std::size_t corners;
  std::array<Point3, 4> places;
  /// Whether beyond the side from each corner to the next is another label, or nothing.
  std::array<bool, 4> is_rim;
};

/// Of all tetrahedra with four corners, in their order.
std::vector<SectionPolygon> section(const FileMesh& mesh, const CutPlane& plane);

}  // namespace certet::view
