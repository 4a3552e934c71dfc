#pragma once
/// \file
/// Third stage, the rule of who moves: violated vertices settle one after the other.
///
/// Where a violated vertex moves onto the surface whatever its neighbours do, thin parts
/// come apart and pieces grow together.  Here it does so only if its link is a strict disk
/// at its turn, so that the mesh keeps the pieces, cavities and tunnels of the samples;
/// otherwise it stays, and the cuts around it are kept alpha away from it.  Two that would
/// pass each other give up one half each of what they are too near; or one stays, if that is
/// nearer to the surface.

#include <cstdint>

#include "certet/context.hpp"
#include "certet/stuffing.hpp"
#include "certet/warp_figures.hpp"
#include "violations.hpp"

namespace certet::core {

/// What became of the violated vertices of a window.
struct Settling {
  SignPlanes planes;  ///< those that move are zero, and nothing else is
  WarpFigures figures = {};  ///< of the window, but for cuts
};

/// `planes` are the samples, of which those on the surface count as minus; `thresholds` those
/// by which vertices are violated.  Moves that would pass a neighbour's are shortened in
/// `violations`.
Settling settle(const SignPlanes& planes, Violations& violations, const Thresholds& thresholds,
                const Lattice& lattice, Window window, Context& context);

}  // namespace certet::core
