#pragma once
/// \file
/// Several solids as one domain of several materials.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// A solid, and what the regions of its mesh are called.
struct NamedSolid {
  std::string name;
  Solid solid;
};

/// How finely several solids are meshed.
struct MaterialsLattice {
  double size = 0;  ///< long edge in world units; 0: a 64th of the longest side of all
  std::int32_t margin = 2;  ///< lattice cells around all of them, at least 1
};

/// Solids that are materials 1, 2, … in their order, and labels of the same numbers.
/// They may overlap: what is in several belongs to the strongest, and what is in none is
/// outside.  By default a solid is stronger than those before it; `priority` has names,
/// the strongest first, and who is not among them is weaker than who is.
///
/// All are on one lattice, around the box of all their bounds, along the axes of the world.
/// Two materials part at the surface of the stronger one.  So a wall that two solids have in
/// common is one interface, and the surface of a weaker one does not matter inside of a
/// stronger one.  A point on the surface of a solid belongs to it.
/// \throws Error `bad_option` (no solids, names that are empty or not unique, a priority
/// that is none of them or there twice), as `lattice_around`, and what the solids throw.
std::unique_ptr<PlacedDomain> materials_domain(const std::vector<NamedSolid>& solids,
                                               const MaterialsLattice& lattice,
                                               const std::vector<std::string>& priority = {});

}  // namespace certet
