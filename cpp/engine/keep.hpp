#pragma once
/// \file
/// Which pieces of a mesh stay, and the lattice without the others.

#include <vector>

#include "certet/pieces.hpp"
#include "plus_runs.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Of each run of plus vertices, whether the piece that it is in stays.
std::vector<bool> runs_that_stay(const PlusRuns& runs, const WarpedLattice& warped,
                                 const Lattice& lattice, const KeepRule& rule, Context& context);

/// The lattice with those runs alone that `stays` has, which no edge joins to others: what
/// is around them is as it was.
WarpedLattice with_runs(const WarpedLattice& warped, const PlusRuns& runs,
                        const std::vector<bool>& stays, const Lattice& lattice,
                        Context& context);

}  // namespace certet::core
