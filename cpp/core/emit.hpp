#pragma once
/// \file
/// Last stage: the numbers that a mesh is made of.

#include <cstdint>

#include "certet/mesh.hpp"
#include "certet/stuffing.hpp"
#include "count.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Writes the points of row (j,k), in the order of RowRanks, from `out` on.
void emit_row_points(const WarpedLattice& warped, const Lattice& lattice, const RowRanks& row,
                     int j, int k, Coord3* out);

/// Tells of the same points whether they lie on the surface.
void mark_row_points(const SignPlanes& planes, const RowRanks& row, int j, int k,
                     std::uint8_t* out);

/// Writes the tetrahedra of rows [j_begin, j_end) of layer k, from `out` on:
/// index by index, case by case, in the order of the stencil.
template <class Index>
void emit_row_tets(const SignPlanes& planes, const RowNumbers& numbers, int j_begin, int j_end,
                   int k, Tet<Index>* out);

}  // namespace certet::core
