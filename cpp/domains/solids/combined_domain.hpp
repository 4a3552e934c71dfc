#pragma once
/// \file
/// Domains on one lattice, made into one.

#include <memory>

#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

using DomainPart = std::shared_ptr<const PlacedDomain>;

/// What is in both, with the labels of the first.  `side` is the longest of the result's box.
DomainPart both(const DomainPart& a, const DomainPart& b, const PlacedLattice& around, double side);

/// What is in either, which is of one material.
DomainPart either(const DomainPart& a, const DomainPart& b, const PlacedLattice& around,
                  double side);

/// The same of one material.
DomainPart as_one(const DomainPart& a);

/// What is not in a domain.
DomainPart opposite(const DomainPart& a);

}  // namespace certet
