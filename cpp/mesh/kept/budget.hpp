#pragma once
/// \file
/// How much a search may ask a shape.

#include "certet/placed_domain.hpp"

namespace certet::core {

/// Cells of lattices that may still be tried.
struct SearchBudget {
  double cells = 4e8;    ///< in all
  double mixed = 6.4e7;  ///< in blocks that are neither inside nor outside

  /// Takes a lattice away.  Whether it was enough.
  bool pay_for(const PlacedDomain& domain);
};

}  // namespace certet::core
