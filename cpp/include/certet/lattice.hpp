#pragma once
/// \file
/// The piece of the lattice that is searched, and where it lies in the world.

#include <array>
#include <cstdint>

#include "certet/bounds.hpp"
#include "certet/frame.hpp"
#include "certet/lattice/coord3.hpp"
#include "certet/lattice/lattice_limits.hpp"

namespace certet {

/// The even points origin + 2 (i,j,k), 0 <= i < cells[0] and so on, and the odd
/// points origin + 2 (i,j,k) + (1,1,1).  `origin` is an even point, in lattice
/// units.  The outermost points (first and last index of each axis) count as
/// outside whatever the domain says, which closes the mesh.
struct Lattice {
  Coord3 origin{0, 0, 0};
  std::array<std::int32_t, 3> cells{0, 0, 0};
};

/// A lattice and the way from it to the world.
struct PlacedLattice {
  Lattice lattice;
  Frame frame;
};

/// Lattice point (0,0,0) is the centre of the bounds, the axes are the world's,
/// and `margin` (at least 1) cells surround the bounds.  `size` is the long edge
/// in world units; 0: a 64th of the longest side.
/// \throws Error `bad_option` (bounds, size, margin), `too_large` (coordinate range, or
/// a size that `checked_size` refuses).
PlacedLattice lattice_around(const Bounds& bounds, double size, std::int32_t margin);

}  // namespace certet
