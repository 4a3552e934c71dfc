#pragma once
/// \file
/// A domain that knows where it lies.

#include <cstdint>

#include "certet/domain.hpp"
#include "certet/frame.hpp"
#include "certet/labels.hpp"
#include "certet/lattice.hpp"

namespace certet {

class PlacedDomain : public Domain {
 public:
  /// From lattice to world.
  [[nodiscard]] virtual const Frame& frame() const = 0;
  /// The piece of the lattice that holds the solid.
  [[nodiscard]] virtual const Lattice& lattice() const = 0;
  /// What labels are called, where that is known.
  [[nodiscard]] virtual LabelNames names() const { return {}; }
  /// Of the solid's box, in world units.
  [[nodiscard]] virtual double longest_side() const = 0;
  /// Bytes that the object holds, where they are many.
  [[nodiscard]] virtual std::uint64_t bytes() const { return 0; }
};

}  // namespace certet
