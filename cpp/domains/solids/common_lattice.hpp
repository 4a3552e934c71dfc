#pragma once
/// \file
/// The lattice that several solids share.

#include <vector>

#include "certet/materials_domain.hpp"

namespace certet {

/// That of the first solid that has one of its own, grown until it holds the others; or that
/// around the box of all.  \throws Error as `own_lattice` and `lattice_holding`.
PlacedLattice common_lattice(const std::vector<NamedSolid>& solids,
                             const MaterialsLattice& choice);

}  // namespace certet
