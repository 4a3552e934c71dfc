#pragma once
/// \file
/// Third stage, first half: signs and cuts → the vertices too close to the surface.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/lattice/warp.hpp"
#include "cuts.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// How a zero vertex is moved; distance 0 means not at all.
struct Displacement {
  std::uint16_t distance = 0;  ///< steps
  std::uint8_t direction = 0;
  bool is_alone = false;  ///< of a violated vertex: no other cut violates it
};

/// The displacements of some vertices of one layer: row by row, grid by grid,
/// in the order of the index.
struct DisplacedLayer {
  std::vector<Displacement> displacements;
  std::vector<std::uint32_t> row_begin;
};
static_assert(std::int64_t{2} * anchor_limit * anchor_limit <= std::uint32_t(-1),
              "32 bits count the vertices of a layer");

/// The vertices that the thresholds violate, and where on the surface each would go:
/// to its nearest cut.  A sample that lies on the surface is violated by a cut at
/// distance 0 if it has a plus neighbour, and otherwise not at all.
struct Violations {
  SignPlanes violated;             ///< in its plus planes
  Layers<DisplacedLayer> targets;  ///< of the violated vertices

  [[nodiscard]] bool contains(Grid grid, int i, int j, int k) const {
    return (violated.plus(grid, j, k)[i >> 6] >> (i & 63) & 1) != 0;
  }
  /// The target of a vertex that is violated.
  [[nodiscard]] const Displacement& target(Grid grid, int i, int j, int k) const;
};

/// Those of the layers `around`; `planes` have a layer more on each side, `cuts` one
/// before, where the lattice has any.
Violations find_violations(const SignPlanes& planes, const Layers<CutLayer>& cuts, Window around,
                           const Thresholds& thresholds, Context& context);

}  // namespace certet::core
