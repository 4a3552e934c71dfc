#pragma once
/// \file
/// Signs and boxes of two solids together.

#include <algorithm>

#include "certet/bounds.hpp"
#include "certet/lattice/sign.hpp"

namespace certet {

/// Of a point in two solids.  What both of them touch is taken for inside: there they share
/// a wall, or else the point is on their common surface and may count as inside too.
constexpr Sign united(Sign one, Sign other) {
  if (one == Sign::on_surface && other == Sign::on_surface) return Sign::plus;
  return std::max(one, other);
}

/// The box around two.
inline Bounds around(const Bounds& one, const Bounds& other) {
  Bounds both = one;
  for (std::size_t a = 0; a < 3; ++a) {
    both.low[a] = std::min(both.low[a], other.low[a]);
    both.high[a] = std::max(both.high[a], other.high[a]);
  }
  return both;
}

}  // namespace certet
