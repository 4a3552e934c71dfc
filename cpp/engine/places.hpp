#pragma once
/// \file
/// Where points of a mesh are, in steps.

#include <array>
#include <cstdint>

#include "certet/lattice.hpp"
#include "vertex_index.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Where a vertex of the lattice is once it has moved.
inline Coord3 moved_place(const Lattice& lattice, const VertexIndex& v, const Displacement& move) {
  return steps * lattice_point(lattice, {v.grid, {}}, v.i, v.j, v.k) +
         std::int32_t{move.distance} * tiling.directions[move.direction];
}

/// Where the edge of a family that an index owns is cut, so far from its first end or its
/// second.
inline Coord3 cut_place(const Lattice& lattice, const Family& family,
                        const std::array<int, 3>& index, bool from_first, std::int32_t cut) {
  const auto& [i, j, k] = index;
  const Coord3 first = lattice_point(lattice, family.first, i, j, k);
  const Coord3 second = lattice_point(lattice, family.second, i, j, k);
  return from_first ? steps * first + cut * (second - first)
                    : steps * second + cut * (first - second);
}

/// Where a point of the mesh is, found by its rank.
Coord3 place_of(const WarpedLattice& warped, const Lattice& lattice, const PointIndex& point);

}  // namespace certet::core
