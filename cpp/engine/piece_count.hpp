#pragma once
/// \file
/// The pieces of a warped lattice's mesh, counted by its signs.
///
/// Every tetrahedron of the mesh has a plus corner, and all that have one in common are
/// joined by faces around it.  So the mesh is in as many pieces by faces as the plus
/// vertices that edges join, but for faces without a plus corner, which have three zero
/// ones: these join what is on their two sides.  By vertices, besides, all is joined that
/// is around a zero vertex.  A cut's tetrahedra all have the plus end of its edge.
///
/// The surface is one fan around every cut, whatever the signs; around a zero vertex its
/// link tells.

#include "certet/pieces.hpp"
#include "plus_runs.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Runs of plus vertices, joined as the mesh is.
struct JoinedRuns {
  DisjointSets by_faces, by_vertices;
  SurfaceFaults surface;
};

/// Of a whole lattice.  Places are in the world of `frame`.
/// \throws Error `cancelled`.
JoinedRuns join_runs(const PlusRuns& runs, const WarpedLattice& warped, const Lattice& lattice,
                     const Frame& frame, Context& context);

/// Of each piece by faces, in the order of their first runs, how many tetrahedra it has.
/// `piece_of` is the piece of each run.
std::vector<std::uint64_t> count_tets_of_pieces(const PlusRuns& runs,
                                                const std::vector<std::uint32_t>& piece_of,
                                                std::size_t pieces, Context& context);

Point3 middle(const Point3& a, const Point3& b);

/// The sets' numbers, from 0 on, by their least elements: of each element, the number of
/// its set.
struct NumberedSets {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};
NumberedSets number_sets(DisjointSets& sets);

/// Of a whole lattice whose mesh has so many tetrahedra.
Pieces count_pieces(const WarpedLattice& warped, const Lattice& lattice, std::uint64_t tets,
                    const Frame& frame, Context& context);

}  // namespace certet::core
