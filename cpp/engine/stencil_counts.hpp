#pragma once
/// \file
/// How many tetrahedra stencils have.

#include <array>
#include <cstdint>

#include "lattice/tiling_in_use.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// The lengths of 64 stencils at once, by their corners' bits, so that counting looks up
/// no table.  A stencil has one tetrahedron if any
/// corner is plus, one more if there is also a minus and a second plus, and a
/// third if, besides, no corner is zero.
struct StencilCounts {
  std::uint64_t one, two, three;
};

constexpr StencilCounts stencil_counts(const std::array<SignWord, 4>& corner) {
  std::uint64_t plus = 0;
  std::uint64_t two_plus = 0;
  std::uint64_t minus = 0;
  std::uint64_t zero = 0;
  for (const SignWord& c : corner) {
    two_plus |= plus & c.plus;
    plus |= c.plus;
    minus |= c.minus();
    zero |= c.zero;
  }
  const std::uint64_t split = two_plus & minus;
  return {plus, split, split & ~zero};
}

/// The rule above is that of the stencils, whatever the order of the cuts.
static_assert([] {
  for (int index = 0; index < pattern_count; ++index) {
    const CutOrders& orders = orders_of_cuts[static_cast<std::size_t>(index)];
    std::array<SignWord, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Sign s = pattern_signs(index)[i];
      corner[i] = {s == Sign::plus ? 1u : 0u, s == Sign::on_surface ? 1u : 0u};
    }
    const StencilCounts counts = stencil_counts(corner);
    const std::uint64_t count = (counts.one & 1) + (counts.two & 1) + (counts.three & 1);
    for (std::size_t order = 0; order < std::size_t{1} << orders.pair_count; ++order)
      if (count != stencils[orders.stencil[order]].count) return false;
  }
  return true;
}());

}  // namespace certet::core
