#pragma once
/// \file
/// Volumes and areas of the regions of fields, estimated from eight points of each cell.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/cell_corners.hpp"
#include "fields/cell_points.hpp"
#include "fields/field_tile.hpp"
#include "fields/hold.hpp"
#include "fields/region_sums.hpp"

namespace certet::fields {

/// How many voxels a surface is away per difference of two fields, in 65536ths.
struct Slopes {
  std::int32_t wide, narrow;  ///< narrow: near thin voxels
};

/// Of smoothing with such a standard deviation: 1.25 times that much, for the difference
/// of the fields on both sides of a plane rises by 2 / sqrt(2 pi) per deviation.
std::int32_t slope_of(double deviation);

/// Adds what a tile has of each region, at points a quarter of a cell's width from its
/// faces.
class TileEstimate {
 public:
  /// `size` is the image's, in voxels.
  TileEstimate(const std::array<std::int64_t, 3>& size, const Slopes& slopes, RegionSums& sums)
      : size_(size), slopes_(slopes), sums_(sums) {}

  /// So many cells along each axis of one material.
  void add_uniform(Material material, const Cell& first_cell, int cells);

  /// `block` is not raised yet.
  void add_block(const BlockView& block, const Cell& first_cell,
                 const Constants& constants, bool hold);

 private:
  class Parts;
  /// At the points of a cell, 64 times as great.
  struct Field {
    Eight values;
    Material of;
    bool is_near;  ///< not 0 in the whole cell
  };

  void add_cell(const BlockView& block, std::size_t node, PointSet points, std::int64_t slope);
  void add_two(const Field& first, const Field& second, PointSet points, std::int64_t slope);
  void add_several(PointSet points, std::int64_t slope);

  std::array<std::int64_t, 3> size_;
  Slopes slopes_;
  RegionSums& sums_;
  HeldBlock held_;
  std::vector<Field> near_;  ///< of the cell
};

}  // namespace certet::fields
