#pragma once
/// \file
/// The pieces of a mesh of several materials, counted by the signs and materials of its
/// lattice.
///
/// Of each material alone all is as of a solid (`piece_count.hpp`): it is in as many pieces
/// by faces as its plus vertices that edges join, but for faces of three zero vertices.
/// What fills the space between three materials shares a face with the tetrahedron at the
/// corner that it belongs to.  The two ends of a cut edge share a face too, unless the
/// edge is long and there is nothing around it but the outside: they share its cut alone.
/// A tetrahedron of four zero vertices joins what is across its faces.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/pieces.hpp"
#include "disjoint_sets.hpp"
#include "region_runs.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Runs, and behind them the tetrahedra of four zero vertices, joined as the mesh is.
struct JoinedRegions {
  DisjointSets by_faces, by_vertices;                  ///< whatever the materials
  DisjointSets region_by_faces, region_by_vertices;    ///< of one material each
  std::vector<Material> materials;                     ///< of all that is joined
  /// The four corners of each tetrahedron of zero vertices.
  std::vector<std::array<VertexIndex, 4>> shared;
  SurfaceFaults surface;
};

/// Of a whole lattice, of planes with materials.  Places are in the world of `frame`.
/// \throws Error `cancelled`.
JoinedRegions join_regions(const RegionRuns& runs, const WarpedLattice& warped,
                           const Lattice& lattice, const Frame& frame, Context& context);

/// Of each piece by faces how many tetrahedra it has.
std::vector<std::uint64_t> count_tets_of_regions(const RegionRuns& runs,
                                                 const JoinedRegions& joined,
                                                 const SignPlanes& planes,
                                                 const std::vector<std::uint32_t>& piece_of,
                                                 std::size_t pieces);

/// Of a whole lattice whose mesh has so many tetrahedra; that of material m is labels[m - 1].
Pieces count_region_pieces(const WarpedLattice& warped, const Lattice& lattice,
                           std::span<const std::int32_t> labels, std::uint64_t tets,
                           const Frame& frame, Context& context);

}  // namespace certet::core
