#pragma once
/// \file
/// A tiling of space by tetrahedra, as data: all that the engine knows of a lattice.

#include <array>
#include <cstddef>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/direction.hpp"
#include "certet/lattice/structured_tet.hpp"

namespace certet {

/// A tiling that repeats itself in every cell, two lattice units along each axis.
/// Everything is told relative to the reference point of a cell, in lattice units.
///
/// It is `Tiling` of coq/Lattice/Tiling.v, cell by cell: the identifier of a
/// tetrahedron is its cell and its case, `VertexOf`, `NeighborAt` and `HandOf` are
/// the row of its case in `tets`.
template <std::size_t grid_number, std::size_t case_number, std::size_t direction_number,
          std::size_t edge_number>
struct Tiling {
  /// An edge, from the vertex that its cell owns, in grids, to another one.
  struct Edge {
    Coord3 first, second;
  };

  /// The vertices of a cell, each 0 or 1 along an axis.
  std::array<Coord3, grid_number> grids;
  /// The tetrahedra of a cell, one for each case.
  std::array<StructuredTetShape, case_number> tets;
  /// From a vertex to its neighbours.  Ties between cuts are broken by this order.
  std::array<Coord3, direction_number> directions;
  /// The edges that a cell owns, one for each family, in the order in which their
  /// cuts are numbered.  Every edge of a tetrahedron is one of them, of its own
  /// cell or another.
  std::array<Edge, edge_number> edges;
};

/// `LatticeTiling` of the certificate: the body-centred cubic lattice.  Edges are
/// the long ones of the even vertex along x, y and z, those of the odd one, and the
/// short ones from the odd vertex to the corners of its cube.
/// Picture: cpp/docs/pictures/lattice.svg.
inline constexpr Tiling<2, case_count, direction_count, 14> lattice_tiling{
    {{{0, 0, 0}, {1, 1, 1}}},
    structured_tet_table,
    direction_offset,
    {{{{0, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 2, 0}}, {{0, 0, 0}, {0, 0, 2}},
      {{1, 1, 1}, {3, 1, 1}}, {{1, 1, 1}, {1, 3, 1}}, {{1, 1, 1}, {1, 1, 3}},
      {{1, 1, 1}, {0, 0, 0}}, {{1, 1, 1}, {2, 0, 0}}, {{1, 1, 1}, {0, 2, 0}},
      {{1, 1, 1}, {2, 2, 0}}, {{1, 1, 1}, {0, 0, 2}}, {{1, 1, 1}, {2, 0, 2}},
      {{1, 1, 1}, {0, 2, 2}}, {{1, 1, 1}, {2, 2, 2}}}}};

}  // namespace certet
