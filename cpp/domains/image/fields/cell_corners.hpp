#pragma once
/// \file
/// The corners of a cell among the nodes of its block.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// How far corner c is from the cell's first node; c lies on the upper side of axis a if
/// bit a of c is set.
inline constexpr std::array<std::size_t, 8> cell_corners{
    node_number(0, 0, 0), node_number(1, 0, 0), node_number(0, 1, 0), node_number(1, 1, 0),
    node_number(0, 0, 1), node_number(1, 0, 1), node_number(0, 1, 1), node_number(1, 1, 1)};

/// A number for each corner of a cell, or for each of its eight points; a vector of both gcc
/// and clang.
using Eight [[gnu::vector_size(32)]] = std::int32_t;

/// A field at the corners of a cell, in their order: two in each word.
using CornerPairs [[gnu::vector_size(16)]] = std::int32_t;

inline CornerPairs corner_pairs(const std::int16_t* first_node) {
  const auto pair = [first_node](std::size_t corner) {
    std::int32_t both = 0;
    std::memcpy(&both, first_node + cell_corners[corner], sizeof(both));
    return both;
  };
  return CornerPairs{pair(0), pair(2), pair(4), pair(6)};
}

inline void spread(const CornerPairs& pairs, Eight& corners) {
  using Shorts [[gnu::vector_size(16)]] = std::int16_t;
  Shorts shorts;
  std::memcpy(&shorts, &pairs, sizeof(shorts));
  corners = __builtin_convertvector(shorts, Eight);
}

}  // namespace certet::fields
