#pragma once
/// \file
/// The surface in fewer triangles.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/formats.hpp"
#include "separating_faces.hpp"

namespace certet::view {

struct CoarseTriangle {
  std::array<std::uint32_t, 3> points;
  std::uint64_t tet;    ///< that it is a face of, or was
  std::uint64_t other;  ///< behind it; `no_tet` at the border of the mesh
};

struct CoarseSurface {
  std::vector<Point3> points;
  std::vector<CoarseTriangle> triangles;
  double cell = 0;  ///< 0: as the mesh has it
};

/// Faces as they are, if there are no more than `limit`.  Otherwise
/// points in the same cell of a cubic grid become one in their middle, triangles
/// without an area are left out, and the grid is made coarser until they are few.
CoarseSurface coarse_surface(const FileMesh& mesh, std::span<const SeparatingFace> faces,
                             std::uint64_t limit);

}  // namespace certet::view
