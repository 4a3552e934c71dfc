#pragma once
/// \file
/// Shapes of the world, before they are put on a lattice.

#include <functional>
#include <memory>

#include "certet/bounds.hpp"
#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

/// A shape that lies in the world but on no lattice yet, so that several can share one.
struct Solid {
  Bounds bounds;  ///< in world units; all of it is within

  /// Makes of it what the engine asks, on a lattice that holds the bounds: a domain of one
  /// material, which may outlive the solid.  May be called for one lattice after the
  /// other.  \throws Error
  std::function<std::shared_ptr<const PlacedDomain>(const PlacedLattice&)> on;
};

}  // namespace certet
