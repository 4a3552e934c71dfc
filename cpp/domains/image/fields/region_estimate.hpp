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

/// What the label with the greatest field has of the eighth of a voxel around a point, and the
/// second one the rest: of a point that is x voxels inside it has min(1, 1/2 + 2x).
class Ramp {
 public:
  explicit Ramp(std::int32_t slope);

  /// In 16384ths, by 64 times how much the first field is ahead: not less than 0.
  void find_parts(const Eight& ahead, Eight& parts) const;
  /// Of the surface that a point stands for which is not all of one label.
  [[nodiscard]] std::int64_t area() const { return area_; }
  /// How far ahead labels are whose points are theirs altogether.
  [[nodiscard]] std::int16_t settled_margin() const { return settled_margin_; }

 private:
  std::int32_t upper_, lower_;  ///< bits of the slope
  std::int32_t settled_;        ///< in 64 times a field's unit
  std::int64_t area_;
  std::int16_t settled_margin_;
};

/// Adds what a tile has of each region, at points a quarter of a cell's width from its
/// faces.
class TileEstimate {
 public:
  /// `size` is the image's, in voxels.
  TileEstimate(const std::array<std::int64_t, 3>& size, const Slopes& slopes, RegionSums& sums)
      : size_(size), wide_(slopes.wide), narrow_(slopes.narrow), sums_(sums) {}

  /// So many cells along each axis of one material.
  void add_uniform(Material material, const Cell& first_cell, int cells);

  /// `block` is not raised yet.
  void add_block(const BlockView& block, const Cell& first_cell,
                 const Constants& constants, bool hold);

 private:
  void add_cell(const BlockView& block, std::size_t node, PointSet points, const Ramp& ramp);
  void add_two(std::size_t first, std::size_t second, PointSet points, const Ramp& ramp);
  void add_several(PointSet points, const Ramp& ramp);

  std::array<std::int64_t, 3> size_;
  Ramp wide_, narrow_;
  RegionSums& sums_;
  HeldBlock held_;
  /// Of the cell: fields at its points, 64 times as great, and whose they are.
  std::vector<Eight> near_;
  std::vector<Material> near_materials_;
  std::size_t near_count_ = 0;
};

}  // namespace certet::fields
