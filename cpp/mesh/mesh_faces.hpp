#pragma once
/// \file
/// All faces of a mesh in memory, brought together once: what is on its outside, what is
/// between its labels, and what hangs together.

#include <cstdint>
#include <span>
#include <vector>

#include "boundary.hpp"
#include "certet/context.hpp"
#include "certet/mesh.hpp"
#include "certet/pieces.hpp"
#include "faces.hpp"
#include "surface_faults.hpp"

namespace certet::core {

struct MeshFaces {
  FaceFindings findings;            ///< without the boundary
  std::vector<BoundaryFace> outer;  ///< those in one tetrahedron, by growing numbers of points
  std::vector<InnerFace> between;   ///< those in two of different labels, in the same order
  std::vector<FacePoints> misoriented;  ///< the points of those of `between` that both
                                        ///< tetrahedra see the same way round, sorted
  Pieces pieces;                    ///< without the faults of the surface
};

/// `labels` is empty or as long as `tets`; tetrahedra that name a point which is not there, or
/// one twice, are left out.  A face in three tetrahedra or more is on the outside of none.
/// \throws Error `cancelled`.
MeshFaces find_mesh_faces(std::uint64_t points, std::span<const Tet<std::uint32_t>> tets,
                          std::span<const std::int32_t> labels, Context& context);
MeshFaces find_mesh_faces(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets,
                          std::span<const std::int32_t> labels, Context& context);

}  // namespace certet::core
