#include "certet/trimmed_domain.hpp"

#include <algorithm>

#include "certet/error.hpp"
#include "combined_domain.hpp"
#include "lattices.hpp"

namespace certet {

std::shared_ptr<const PlacedDomain> trimmed_domain(std::shared_ptr<const PlacedDomain> whole,
                                                   const std::vector<Solid>& inside,
                                                   const std::vector<Solid>& without) {
  PlacedLattice around{whole->lattice(), whole->frame()};
  double side = whole->longest_side();
  for (const Solid& solid : inside) {
    const auto left =
        common(around.lattice, lattice_holding(around.frame, solid.bounds, 2));
    if (!left)
      throw Error(ErrorCode::empty_domain, "nothing is inside of what it is to be inside of");
    around.lattice = *left;
    side = std::min(side, longest_side(solid.bounds));
  }
  DomainPart part = std::move(whole);
  for (const Solid& solid : inside) part = both(part, placed_on(solid, around), around, side);
  for (const Solid& solid : without)
    if (common(around.lattice, lattice_holding(around.frame, solid.bounds, 1)))
      part = both(part, opposite(placed_on(solid, around)), around, side);
  return part;
}

}  // namespace certet
