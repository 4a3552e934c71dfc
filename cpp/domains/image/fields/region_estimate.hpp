#pragma once
/// \file
/// Volumes and areas of the regions of fields, estimated from nodes and the centres of
/// cells.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fields/field_tile.hpp"
#include "fields/hold.hpp"

namespace certet::fields {

/// A voxel, in the unit of sums.  A part of the volume around a point is counted in thirds
/// of 16384ths; a node has a weight of 64, which is a third of all, and a cell of 128.
inline constexpr double volume_unit = 3.0 * field_one * (64 + 128);

/// By material.
struct RegionSums {
  explicit RegionSums(std::size_t materials) : volume(materials, 0), area(materials, 0) {}
  RegionSums& operator+=(const RegionSums& other);
  std::vector<std::int64_t> volume;
  std::vector<std::int64_t> area;  ///< by how much volumes grow with the field
};

/// How many voxels one is inside per difference of two fields, in 65536ths: 1.25 times
/// the standard deviation of smoothing.
std::int64_t slope_of(double deviation);

struct Slopes {
  std::int64_t wide, narrow;  ///< narrow: near thin voxels
};

/// Adds what a tile has of each region.
class TileEstimate {
 public:
  /// `size` is the image's, in voxels.
  TileEstimate(const std::array<std::int64_t, 3>& size, const Slopes& slopes, RegionSums& sums)
      : size_(size), slopes_(slopes), sums_(sums) {}

  /// So many cells along each axis, and the nodes that they start with, of one material.
  void add_uniform(Material material, const std::array<std::int64_t, 3>& first_cell, int cells);

  /// `block` is not raised yet.
  void add_block(const BlockView& block, const std::array<std::int64_t, 3>& first_cell,
                 const Constants& constants, bool hold);

 private:
  class BlockEstimate;

  std::array<std::int64_t, 3> size_;
  Slopes slopes_;
  RegionSums& sums_;
  std::vector<std::int32_t> values_;
};

}  // namespace certet::fields
