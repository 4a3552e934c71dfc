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
  bool keeps_labels = false;  ///< each label of the solid is a material, and keeps its number
};

/// How finely several solids are meshed.
struct MaterialsLattice {
  /// Long edge in world units; 0: what the lattice has that they share, or a 64th of the longest
  /// side of all.
  double size = 0;
  std::int32_t margin = 2;  ///< lattice cells around all of them, at least 1
};

/// Solids that have the labels 1, 2, … in their order or, where some keep labels of their own, the
/// next after the greatest of these.  Materials are numbered from the weakest on, which is not
/// the order of labels where there is a priority.
/// They may overlap: what is in several belongs to the strongest, and what is in none is
/// outside.  By default a solid is stronger than those before it; `priority` has names,
/// the strongest first, and who is not among them is weaker than who is.
///
/// All are on one lattice: that of the first which has its own, grown until it holds the others,
/// or else one around the box of all their bounds, along the axes of the world.
/// Two materials part at the surface of the stronger one.  So a wall that two solids have in
/// common is one interface, and the surface of a weaker one does not matter inside of a
/// stronger one.  A point on the surface of a solid belongs to it.
/// \throws Error `bad_option` (no solids, names that are empty or not unique, a priority
/// that is none of them or there twice), `bad_input` (labels that two solids keep), as
/// `lattice_around` and `lattice_holding`, and what the solids throw.
std::unique_ptr<PlacedDomain> materials_domain(const std::vector<NamedSolid>& solids,
                                               const MaterialsLattice& lattice,
                                               const std::vector<std::string>& priority = {});

}  // namespace certet
