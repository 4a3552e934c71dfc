#pragma once
/// \file
/// The part of a domain that is in some solids and not in others.

#include <memory>
#include <vector>

#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// What is in all of `inside` and in none of `without`, on the lattice of the whole without the
/// cells beyond `inside`.  Labels stay; a point on the surface of a solid belongs to what is left.
/// \throws Error `empty_domain` where a lattice has nothing in common with a solid it is to be
/// in, and what the solids throw.
std::shared_ptr<const PlacedDomain> trimmed_domain(std::shared_ptr<const PlacedDomain> whole,
                                                   const std::vector<Solid>& inside,
                                                   const std::vector<Solid>& without);

}  // namespace certet
