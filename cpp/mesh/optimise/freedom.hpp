#pragma once
/// \file
/// How the vertices of a mesh may move.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/domain.hpp"
#include "vector.hpp"

namespace certet::optimising {

enum class Place {
  inside,   ///< of a region, or of a face where the shape is cut off: any way, within that
  surface,  ///< of the boundary or of an interface: along it
  seam,     ///< where more than two regions meet: along `along`
  corner,   ///< it stays
};

struct Freedom {
  Place place = Place::inside;
  Vector along{};                 ///< of length 1: the surface's normal, or the seam itself
  std::array<bool, 3> held{};     ///< the axes along which it may not move
  Coord3 inward{};                ///< from a face that cuts the shape off, a few steps
  bool outer = true;              ///< on the boundary
  bool labelled = false;          ///< whether the labels of the surface's sides tell it
  std::int32_t within = 0, beyond = 0;  ///< labels; of the boundary the former alone

  /// What is left of a direction, as far as it is free.
  [[nodiscard]] Vector part_of(Vector direction) const;
};

/// A face at a vertex, as a tetrahedron there has it.
struct Sheet {
  std::array<std::uint64_t, 2> others;  ///< its other points, counterclockwise from outside
  std::array<Vector, 2> edges;          ///< to these
  std::int32_t label;                   ///< of the tetrahedron; 0 of all where that does not count
  bool border;                          ///< all its points lie where the shape is cut off
};

/// How a vertex may move at which all tetrahedra have these faces, as the surfaces among them
/// say.  `labelled`: whether regions are cut apart by their labels.  Leaves of `sheets` nothing
/// that means anything.
Freedom freedom_of(std::vector<Sheet>& sheets, bool labelled);

}  // namespace certet::optimising
