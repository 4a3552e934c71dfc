#pragma once
/// \file
/// The corners of a cell among the nodes of its block.

#include <array>
#include <cstddef>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// How far corner c is from the cell's first node; c lies on the upper side of axis a if
/// bit a of c is set.
inline constexpr std::array<std::size_t, 8> cell_corners{
    node_number(0, 0, 0), node_number(1, 0, 0), node_number(0, 1, 0), node_number(1, 1, 0),
    node_number(0, 0, 1), node_number(1, 0, 1), node_number(0, 1, 1), node_number(1, 1, 1)};

}  // namespace certet::fields
