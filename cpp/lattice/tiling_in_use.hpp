#pragma once
/// \file
/// The tiling and the stencils that the engine runs on.
///
/// Every table of the engine is computed from these two when it is compiled, so
/// that others stand here in their place without a word changed in the engine, and
/// without a cost at run time; tests/tilings does so.  The stencils must have as
/// many tetrahedra as `stencil_counts` says, and fit across the tiling's faces:
/// those of the certificate do wherever neighbours are lined up as the lattice's are.

#include "certet/lattice/stencil.hpp"
#include "certet/lattice/tiling.hpp"

namespace certet::core {

inline constexpr const auto& tiling = lattice_tiling;
inline constexpr const auto& stencils = stencil_table;

}  // namespace certet::core
