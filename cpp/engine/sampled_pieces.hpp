#pragma once
/// \file
/// The pieces of a shape on a lattice, of which no mesh is made.

#include <cstdint>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "certet/method.hpp"

namespace certet::core {

/// How many pieces the lattice points inside make that edges of the lattice join: as many
/// as the mesh has by `Method::embedded`, whose warp keeps them.  The lattice is sampled,
/// and nothing else is done.  \throws Error `cancelled`, `too_large`; what the domain throws.
std::uint64_t count_sampled_pieces(const Domain& domain, const Lattice& lattice, Method method,
                                   Context& context);

}  // namespace certet::core
