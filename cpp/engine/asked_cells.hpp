#pragma once
/// \file
/// The cells of an octree that a user's sizes ask for.

#include <vector>

#include "cell_planes.hpp"
#include "certet/context.hpp"
#include "certet/grading.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// By level, those within which some cell of level 0 has no more levels than that: they are
/// not to be filled by a larger one.  Of cells of level 0 that exist anyway nothing is asked.
/// Nothing where all may have as many levels as there are.
std::vector<CellPlane> asked_cells(const SignPlanes& planes, const Lattice& lattice,
                                   const CellPlane& existing, const Grading& grading,
                                   Context& context);

}  // namespace certet::core
