#pragma once
/// \file
/// How the vertices of a mesh may move.

#include <array>
#include <cstdint>
#include <span>

#include "certet/domain.hpp"
#include "vector.hpp"
#include "vertex_faces.hpp"

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

/// A triangle of a surface at a vertex.
struct Sheet {
  VertexFace face;
  std::array<Vector, 2> edges;  ///< to the face's other points
  bool border;                  ///< it lies where the shape is cut off

  [[nodiscard]] bool on_surface_of(const Sheet& other) const {
    return border == other.border &&
           (border || (face.outer == other.face.outer && face.label == other.face.label &&
                       face.beyond == other.face.beyond));
  }
};

/// How a vertex may move at which surfaces have these triangles.  `labelled`: whether regions are
/// cut apart by their labels.
Freedom freedom_of(std::span<const Sheet> sheets, bool labelled);

}  // namespace certet::optimising
