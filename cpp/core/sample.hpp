#pragma once
/// \file
/// First stage: domain → signs.

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/stuffing.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// Signs of all lattice vertices; those on the rim are minus.
SignPlanes sample(const Domain& domain, const Lattice& lattice, Context& context);

}  // namespace certet::core
