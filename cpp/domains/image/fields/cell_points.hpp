#pragma once
/// \file
/// Points of a cell, in the middle of equal parts of it, and which of them lie in an image.

#include <array>
#include <cstdint>

#include "fields/field_tile.hpp"

namespace certet::fields {

/// A bit for each of the points, the first axis running fastest.
using PointSet = std::uint64_t;

/// Along an axis, of an image of so many voxels: cells 0 and `voxels` are half beyond it.
template <unsigned parts>
constexpr unsigned points_along(std::int64_t cell, std::int64_t voxels) {
  constexpr unsigned lower = (1U << parts / 2) - 1, upper = lower << parts / 2;
  return cell > voxels ? 0 : (cell != 0 ? lower : 0U) | (cell != voxels ? upper : 0U);
}

/// Of a cell with parts^3 points, in an image of that size.
template <unsigned parts>
PointSet points_within(const Cell& cell, const std::array<std::int64_t, 3>& size) {
  constexpr unsigned count = parts * parts * parts;
  constexpr PointSet all = ~PointSet{0} >> (64 - count);
  constexpr unsigned all_along = (1U << parts) - 1;
  const unsigned x = points_along<parts>(cell[0], size[0]),
                 y = points_along<parts>(cell[1], size[1]),
                 z = points_along<parts>(cell[2], size[2]);
  if ((x & y & z) == all_along) return all;
  PointSet set = 0;
  for (unsigned p = 0; p < count; ++p)
    set |= PointSet{x >> p % parts & y >> p / parts % parts & z >> p / (parts * parts) & 1} << p;
  return set;
}

}  // namespace certet::fields
