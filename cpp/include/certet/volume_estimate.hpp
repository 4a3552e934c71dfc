#pragma once
/// \file
/// How much is inside of a domain.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/frame.hpp"
#include "certet/lattice.hpp"

namespace certet {

struct VolumeEstimate {
  double volume = 0;     ///< world units cubed
  double deviation = 0;  ///< a bound on its standard deviation
};

/// Asks a domain about some `samples` points between those of the lattice, spread
/// evenly over the blocks whose `extent` is mixed.  The points are always the same.
/// \throws Error `cancelled`; whatever the domain throws.
VolumeEstimate estimate_volume(const Domain& domain, const Lattice& lattice, const Frame& frame,
                               std::uint64_t samples, const Context& context);

/// The same of each material of a domain, the first one's first, from the same points.
std::vector<VolumeEstimate> estimate_volumes(const Domain& domain, const Lattice& lattice,
                                             const Frame& frame, std::uint64_t samples,
                                             const Context& context);

}  // namespace certet
