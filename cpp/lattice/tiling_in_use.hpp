#pragma once
/// \file
/// The tiling and the stencils that the engine runs on.
///
/// Every table of the engine is computed from these two when it is compiled, so
/// that others stand here in their place without a word changed in the engine, and
/// without a cost at run time; tests/tilings does so.  The stencils must have as
/// many tetrahedra as `stencil_counts` says, whatever the order of the cuts, and fit across
/// the tiling's faces: those of the certificate do wherever neighbours are lined up as the
/// lattice's are.

#include "certet/lattice/key_stencil.hpp"
#include "certet/lattice/tiling.hpp"

namespace certet::core {

inline constexpr const auto& tiling = lattice_tiling;
/// Of each pattern, by the order of its cuts: that of equal ones has number 0, and where
/// diagonals do not follow the cuts there is no other.
inline constexpr const auto& orders_of_cuts = cut_orders;
inline constexpr const auto& stencils = key_stencil_table;

}  // namespace certet::core
