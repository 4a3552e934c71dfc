#pragma once
/// \file
/// The fourteen edges of a lattice vertex.

#include <array>

#include "certet/lattice/coord3.hpp"

namespace certet {

inline constexpr int direction_count = 14;

/// Steps to the 14 neighbours, in lattice units: six long edges to the same
/// grid, then eight short ones to the other.  Opposite directions stand side
/// by side (d and d ^ 1).  Ties between cuts are broken by this order.
inline constexpr std::array<Coord3, direction_count> direction_offset{{
    {2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2},
    {1, 1, 1}, {-1, -1, -1}, {1, 1, -1}, {-1, -1, 1},
    {1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1}}};

constexpr bool is_long(int direction) { return direction < 6; }

/// The square of an edge's length, in lattice units.
constexpr int length_squared(int direction) { return is_long(direction) ? 4 : 3; }

}  // namespace certet
