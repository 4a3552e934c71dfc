#pragma once
/// \file
/// Which layers of a lattice each rank has.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "certet/method.hpp"
#include "certet/ranks.hpp"
#include "count.hpp"
#include "window.hpp"

namespace certet::core {

/// What a rank has of a mesh that several make together.
struct Share {
  Ranks* ranks;
  Window own;  ///< its points and tetrahedra are this rank's
  bool knows_all;  ///< whether it has the signs and numbers of all layers
  std::uint64_t points, tets;  ///< of the whole mesh
};

/// Where the layers of each rank end, so that all have about as much work and each a layer at
/// least: rank r has the layers [bounds[r], bounds[r + 1]).  Depends on the work of each layer
/// alone.  \throws Error `bad_option` if there are more ranks than layers.
std::vector<std::int32_t> balanced_bounds(std::span<const std::uint64_t> work, int ranks);

/// The work that a layer makes, if it has so many points and tetrahedra.
std::uint64_t work_of_layer(const Lattice& lattice, std::uint64_t points, std::uint64_t tets);

/// The layers of this rank, by a first count of the lattice before its vertices move, of which
/// each rank makes an equal part.
Window balanced_window(const Domain& domain, const Lattice& lattice, const MethodFacts& method,
                       Ranks& ranks, Context& context);

/// The same of a lattice that every rank has counted.
Window balanced_window(const RowNumbers& numbers, const Lattice& lattice, const Ranks& ranks);

/// Numbers the rank's points and tetrahedra behind those of the ranks before it.
Share numbered_share(RowNumbers& numbers, Window own, Ranks& ranks);

}  // namespace certet::core
