#pragma once
/// \file
/// Stands in the place of cpp/lattice/tiling_in_use.hpp.

#include "certet/lattice/key_stencil.hpp"
#include "kuhn_tiling.hpp"
#include "ordered_stencils.hpp"

namespace certet::core {

inline constexpr const auto& tiling = tilings::kuhn_tiling;
inline constexpr const auto& stencils = tilings::ordered_stencils;
/// No cut is compared with another.
inline constexpr auto orders_of_cuts = [] {
  std::array<CutOrders, pattern_count> table{};
  for (std::size_t p = 0; p < pattern_count; ++p)
    table[p].stencil[0] = static_cast<std::uint8_t>(p);
  return table;
}();

}  // namespace certet::core
