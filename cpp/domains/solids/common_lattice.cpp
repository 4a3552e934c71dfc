#include "common_lattice.hpp"

#include <algorithm>

#include "lattices.hpp"
#include "united.hpp"

namespace certet {

PlacedLattice common_lattice(const std::vector<NamedSolid>& solids,
                             const MaterialsLattice& choice) {
  const auto owner = std::ranges::find_if(
      solids, [](const NamedSolid& one) { return static_cast<bool>(one.solid.own); });
  if (owner == solids.end()) {
    Bounds all = solids.front().solid.bounds;
    for (const NamedSolid& one : solids) all = around(all, one.solid.bounds);
    return lattice_around(all, choice.size, choice.margin);
  }
  PlacedLattice common = owner->solid.own(choice.size, choice.margin);
  for (const NamedSolid& one : solids)
    if (&one != &*owner)
      common.lattice = around(common.lattice, lattice_holding(common.frame, one.solid.bounds,
                                                              choice.margin));
  return common;
}

}  // namespace certet
