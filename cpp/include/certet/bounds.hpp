#pragma once
/// \file
/// Boxes of the world, and lattices around them.

#include <cstdint>

#include "certet/frame.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// An axis-aligned box in world coordinates.
struct Bounds {
  Point3 low, high;
};

/// In world units.
double longest_side(const Bounds& bounds);

/// Where a lattice lies that fills a box.
struct BoxLattice {
  Frame frame;
  Lattice lattice;
};

/// Lattice point (0,0,0) is the centre of the bounds, the axes are the world's,
/// and `margin` (at least 1) cells surround the bounds.  `size` is the long edge
/// in world units; 0: a 64th of the longest side.
/// \throws Error `bad_option` (bounds, size, margin), `too_large` (coordinate range, or
/// a size that `checked_size` refuses).
BoxLattice lattice_around(const Bounds& bounds, double size, std::int32_t margin);

}  // namespace certet
