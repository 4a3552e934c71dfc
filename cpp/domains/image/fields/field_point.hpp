#pragma once
/// \file
/// A point among the nodes of fields, in whole numbers.

#include <array>
#include <cstddef>
#include <cstdint>

namespace certet::fields {

/// A 2^20th of a voxel; a step is that or more for lattices of up to 8 cells per voxel.
inline constexpr int point_bits = 20;
inline constexpr std::int64_t point_one = std::int64_t{1} << point_bits;

/// The numbers of a cell along the axes: cell c lies between nodes c and c + 1, which are
/// voxels c - 1 and c.
using Cell = std::array<std::int64_t, 3>;

/// Coordinates in nodes, along the stored axes of the image, in 2^20ths.
struct FieldPoint {
  std::array<std::int64_t, 3> at;

  [[nodiscard]] Cell cell() const {
    return {at[0] >> point_bits, at[1] >> point_bits, at[2] >> point_bits};
  }
  /// How far into its cell.
  [[nodiscard]] std::array<std::int64_t, 3> within() const {
    constexpr std::int64_t mask = point_one - 1;
    return {at[0] & mask, at[1] & mask, at[2] & mask};
  }
};

/// Of the eight corners of a cell, where corner c lies on the upper side of axis a if bit
/// a of c is set.
using Corners = std::array<std::int32_t, 8>;

/// In 2^20ths of a value's unit, rounded down after the second axis, and exact at
/// corners.  Values of less than 2^18 do not overflow.
constexpr std::int64_t trilinear(const Corners& corner, const std::array<std::int64_t, 3>& within) {
  std::array<std::int64_t, 4> along_x{};  // in 2^20ths
  for (std::size_t c = 0; c < 4; ++c)
    along_x[c] = corner[2 * c] * point_one + (corner[2 * c + 1] - corner[2 * c]) * within[0];
  std::array<std::int64_t, 2> along_y{};
  for (std::size_t c = 0; c < 2; ++c)
    along_y[c] = along_x[2 * c] +
                 (((along_x[2 * c + 1] - along_x[2 * c]) * within[1]) >> point_bits);
  return along_y[0] + (((along_y[1] - along_y[0]) * within[2]) >> point_bits);
}

}  // namespace certet::fields
