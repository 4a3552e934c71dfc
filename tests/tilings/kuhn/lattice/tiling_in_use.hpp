#pragma once
/// \file
/// Stands in the place of cpp/lattice/tiling_in_use.hpp.

#include "kuhn_tiling.hpp"
#include "ordered_stencils.hpp"

namespace certet::core {

inline constexpr const auto& tiling = tilings::kuhn_tiling;
inline constexpr const auto& stencils = tilings::ordered_stencils;

}  // namespace certet::core
