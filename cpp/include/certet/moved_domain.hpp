#pragma once
/// \file
/// A domain on another lattice than the one it was made for.

#include <memory>

#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

/// The same shape for a lattice that lies anywhere.  All of it is on the domain's own lattice;
/// beyond that all is outside.
///
/// Where the two lattices have their points in common, as those of one image do, and axes along
/// each other, every answer is the domain's, of the same position.  Else it is that of the nearest
/// position in the domain's own steps; also of one that two axes turned into each other would
/// meet exactly, as long as origins and long edges are the same.
std::shared_ptr<const PlacedDomain> moved_domain(std::shared_ptr<const PlacedDomain> domain,
                                                 const PlacedLattice& around);

/// The same of a shape whose world is seen turned: `there` is the lattice's frame in the domain's
/// own world, `around.frame` in that of whoever asks.
std::shared_ptr<const PlacedDomain> moved_domain(std::shared_ptr<const PlacedDomain> domain,
                                                 const PlacedLattice& around, const Frame& there);

}  // namespace certet
