#pragma once
/// \file
/// Which pieces of a mesh stay, and the lattice without the others.

#include "certet/pieces.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// The lattice of a mesh in two: what stays, and the rest.  No face joins the two: the
/// tetrahedra of either are as they were.
struct SplitLattice {
  WarpedLattice kept, rest;
};
SplitLattice split(const WarpedLattice& warped, const Lattice& lattice, const KeepRule& rule,
                   Context& context);

}  // namespace certet::core
