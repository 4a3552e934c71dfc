#pragma once
/// \file
/// Where single points of a mesh are.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice.hpp"
#include "material_links.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Where a zero vertex has moved to, in steps.
Coord3 moved_place(const WarpedLattice& warped, const Lattice& lattice, const VertexIndex& v);

/// The cut edge from a vertex in a direction.
struct CutEdge {
  VertexIndex owner;
  std::size_t family;
};
CutEdge edge_from(const VertexIndex& v, std::size_t direction);

/// Where it is cut, in steps.
Coord3 cut_place(const WarpedLattice& warped, const Lattice& lattice, const CutEdge& edge);

}  // namespace certet::core
