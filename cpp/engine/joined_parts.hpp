#pragma once
/// \file
/// The parts of a warped lattice's mesh, joined to pieces by its signs and materials.
///
/// Of a solid every tetrahedron has a plus corner, and all that have one in common are
/// joined by faces around it.  So the mesh is in as many pieces by faces as the plus
/// vertices that edges join, but for faces without a plus corner, which have three zero
/// ones: these join what is on their two sides.  By vertices, besides, all is joined that
/// is around a zero vertex.  A cut's tetrahedra all have the plus end of its edge, and the
/// surface is one fan around every cut; around a zero vertex its link tells.
///
/// Of each of several materials all is so too.  What fills the space between three of them
/// shares a face with the tetrahedron at the corner that it belongs to.  The two ends of a
/// cut edge share a face too, unless the edge is long and there is nothing around it but
/// the outside: they share its cut alone.  A tetrahedron of four zero vertices joins what
/// is across its faces.

#include <array>
#include <cstdint>
#include <vector>

#include "layer_joins.hpp"

namespace certet::core {

struct JoinedSets {
  DisjointSets by_faces, by_vertices;
};

/// Points and edges at which the surface is no manifold, as the mesh's points are numbered.
struct FaultPoints {
  std::vector<PointIndex> vertices;
  std::vector<std::array<PointIndex, 2>> edges;
};

/// The parts, which are runs and, behind them, the tetrahedra of four zero vertices.
struct MeshParts {
  PlusRuns runs;
  ZeroTets zero_tets;
  JoinedSets whole;    ///< whatever the materials
  JoinedSets regions;  ///< within each of several materials; else of no part
  FaultPoints faults;

  [[nodiscard]] std::uint32_t size() const { return runs.size() + zero_tets.size(); }
  /// Of a part, where there are several materials.
  [[nodiscard]] Material material(std::uint32_t part) const;
};

/// Of a whole lattice.  \throws Error `too_large` if 32 bits do not count the parts,
/// `cancelled`.
MeshParts join_parts(const SignPlanes& planes, Context& context);

}  // namespace certet::core
