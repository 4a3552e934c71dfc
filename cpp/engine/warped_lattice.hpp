#pragma once
/// \file
/// Third stage: signs and cuts → the warped lattice.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/lattice/warp.hpp"
#include "cuts.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// How a zero vertex was moved; distance 0 means not at all.
struct Displacement {
  std::uint16_t distance = 0;  ///< steps
  std::uint8_t direction = 0;
};

/// The displacements of one layer's zero vertices: row by row, grid by grid,
/// in the order of the index.
struct ZeroLayer {
  std::vector<Displacement> displacements;
  std::vector<std::uint32_t> row_begin;
};
static_assert(std::int64_t{2} * anchor_limit * anchor_limit <= std::uint32_t(-1),
              "32 bits count the vertices of a layer");

/// What stuffing needs of the domain, for the mesh of a window.  Zero vertices
/// without a plus neighbour, which no tetrahedron of the output uses, are turned
/// to minus, so that every plus or zero vertex of `planes` is a point of the
/// output; that is so in the layers of `warped_window`.
struct WarpedLattice {
  SignPlanes planes;
  Layers<CutLayer> cuts;  ///< of the window: those that are left, in the order of `planes`
  Layers<ZeroLayer> zeros;
};

/// The vertices around a window that the thresholds violate, and where they go.
/// `planes` are those of `sampled_window`, `cuts` those of `cut_window`.
class Violations {
 public:
  Violations(const SignPlanes& planes, const Layers<CutLayer>& cuts, const Lattice& lattice,
             Window window, const Thresholds& thresholds, Context& context);

  /// Tetrahedra of the window whose four vertices all became zero and whose
  /// volume is no longer positive.
  [[nodiscard]] std::uint64_t inverted_tets(Context& context) const;

  /// The window with the violated vertices moved.
  [[nodiscard]] WarpedLattice apply(Context& context) const;

 private:
  const SignPlanes& planes_;
  const Layers<CutLayer>& cuts_;
  const Lattice& lattice_;
  Window window_;
  SignPlanes violated_;        ///< in its plus planes
  Layers<ZeroLayer> moves_;    ///< of the violated vertices
};

/// A window in which no vertex is violated, and none lies on the surface: what
/// cuts in the middle leave.  `cuts` are those of the window.
WarpedLattice unwarped(SignPlanes planes, Layers<CutLayer> cuts, Window window);

}  // namespace certet::core
