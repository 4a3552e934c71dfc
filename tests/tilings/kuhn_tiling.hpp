#pragma once
/// \file
/// Another tiling: every cube cut into six tetrahedra along its diagonal (Freudenthal,
/// Kuhn).  A tetrahedron goes from corner 0 to corner 7 along three sides, in one of
/// six orders of the axes.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/tiling.hpp"

namespace certet::tilings {

using Axes = std::array<std::size_t, 3>;
inline constexpr std::array<Axes, 6> axes_orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

constexpr Coord3 side(std::size_t axis) {
  return {axis == 0 ? 2 : 0, axis == 1 ? 2 : 0, axis == 2 ? 2 : 0};
}

constexpr StructuredTetCase case_of(const Axes& axes) {
  std::uint8_t n = 0;
  while (axes_orders[n] != axes) ++n;
  return StructuredTetCase{n};
}

/// The neighbours across the first and the last vertex are in other cells.
constexpr StructuredTetShape tet_along(const Axes& axes) {
  const auto [a, b, c] = axes;
  const Coord3 none{0, 0, 0};
  const bool even = (b + 3 - a) % 3 == 1;  // a rotation of x y z
  return {{{none, side(a), side(a) + side(b), {2, 2, 2}}},
          {{{{side(a), case_of({b, c, a})}, {3, 0, 1, 2}},
            {{none, case_of({b, a, c})}, {0, 1, 2, 3}},
            {{none, case_of({a, c, b})}, {0, 1, 2, 3}},
            {{none - side(c), case_of({c, a, b})}, {1, 2, 3, 0}}}},
          even};
}

using KuhnTiling = Tiling<1, 6, 14, 7>;

/// Edges lead from a corner to each of the seven others of its cube, by growing number.
inline constexpr KuhnTiling kuhn_tiling = [] {
  KuhnTiling tiling{};
  for (std::size_t t = 0; t < axes_orders.size(); ++t) tiling.tets[t] = tet_along(axes_orders[t]);
  for (int corner = 1; corner < 8; ++corner) {
    const Coord3 edge{2 * (corner & 1), 2 * (corner >> 1 & 1), 2 * (corner >> 2 & 1)};
    const auto n = static_cast<std::size_t>(corner - 1);
    tiling.edges[n] = {{0, 0, 0}, edge};
    tiling.directions[2 * n] = edge;
    tiling.directions[2 * n + 1] = -1 * edge;
  }
  return tiling;
}();

}  // namespace certet::tilings
