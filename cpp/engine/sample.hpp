#pragma once
/// \file
/// First stage: domain → signs, and materials.

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "certet/method.hpp"
#include "sign_planes.hpp"
#include "window.hpp"

namespace certet::core {

/// Signs of the vertices of a window; those on the lattice's rim are minus.  With midpoint
/// cuts a vertex on the surface counts as inside: the angles proven for them
/// are those of a domain that is either in or out.  Where violated vertices settle,
/// cubes are parted if the domain asks for it.  Where the method cuts several materials
/// apart, the planes have those of the vertices, and whatever is not outside is plus.
SignPlanes sample(const Domain& domain, const Lattice& lattice, Window window,
                  const MethodFacts& method, Context& context);

}  // namespace certet::core
