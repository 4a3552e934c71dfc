#pragma once
/// \file
/// Third stage, second half: the signs and cuts that are left once vertices have moved.

#include <cstdint>
#include <utility>

#include "certet/context.hpp"
#include "certet/warp_figures.hpp"
#include "cuts.hpp"
#include "sign_planes.hpp"
#include "violations.hpp"

namespace certet::core {

/// What stuffing needs of the domain, for the mesh of a window.  Zero vertices
/// that no tetrahedron of the output uses, those without a plus neighbour, are turned
/// to minus, so that every plus or zero vertex of `planes` is a point of the
/// output; that is so in the layers of `warped_window`.
struct WarpedLattice {
  SignPlanes planes;
  /// Those that are left, in the order of `planes`; also of the layer behind, where the lattice
  /// has one: tetrahedra of the window look at them if diagonals follow the cuts.
  Layers<CutLayer> cuts;
  Layers<DisplacedLayer> zeros;
  WarpFigures figures = {};  ///< of the window
  /// Whether diagonals end at the lesser cut; else the Parity Rule says where.
  bool diagonals_follow_cuts = false;
};

/// The lattice's signs before and after its vertices moved.
struct MovedSigns {
  const SignPlanes& before;
  SignPlanes after;
};

/// The signs once every violated vertex has moved: the paper's rule.
SignPlanes move_all(const SignPlanes& planes, const Violations& violations, Context& context);

/// Tetrahedra of the window whose four vertices are zero in `moved`, and whose volume is
/// no longer positive.
std::uint64_t inverted_tets(const SignPlanes& moved, const Violations& violations,
                            const Lattice& lattice, Window window, Context& context);

/// The window once vertices have moved, which `moved.after` tells; cuts that are less than
/// `least` away from an end are moved to there.  The figures are those of the layers of the window
/// that are in `counted` too.
WarpedLattice warp_lattice(MovedSigns moved, const Violations& violations,
                           const Layers<CutLayer>& cuts, const Thresholds& least,
                           const Lattice& lattice, Window window, Window counted,
                           Context& context);
inline WarpedLattice warp_lattice(MovedSigns moved, const Violations& violations,
                                  const Layers<CutLayer>& cuts, const Thresholds& least,
                                  const Lattice& lattice, Window window, Context& context) {
  return warp_lattice(std::move(moved), violations, cuts, least, lattice, window, window, context);
}

/// Turns the zero vertices that no tetrahedron of the output uses to minus, in the layers
/// of a window.
void drop_idle_zeros(SignPlanes& planes, Window window, Context& context);

/// A window in which no vertex is violated, and none lies on the surface: what
/// cuts in the middle leave.  `cuts` are those of the window.
WarpedLattice unwarped(SignPlanes planes, Layers<CutLayer> cuts, Window window);

}  // namespace certet::core
