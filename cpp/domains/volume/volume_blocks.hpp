#pragma once
/// \file
/// Which blocks of a grid are on one side of a level.

#include <openvdb/openvdb.h>

#include <cstdint>
#include <vector>

#include "certet/domain.hpp"

namespace certet {

/// The leaves of a grid, and what is between them, around its active voxels.
class VolumeBlocks {
 public:
  /// Inside is where sign * value < sign * level.
  VolumeBlocks(const openvdb::FloatGrid& grid, double level, double sign);

  /// Of all values in a box of voxels, both ends included.
  [[nodiscard]] Extent extent(const openvdb::CoordBBox& voxels) const;
  [[nodiscard]] std::uint64_t bytes() const { return extents_.size(); }

 private:
  static constexpr int dimension = static_cast<int>(openvdb::FloatTree::LeafNodeType::DIM);

  void fill(const openvdb::CoordBBox& voxels, Extent extent);
  [[nodiscard]] openvdb::CoordBBox blocks_of(const openvdb::CoordBBox& voxels) const;
  [[nodiscard]] std::size_t block(const openvdb::Coord& at) const;

  openvdb::CoordBBox blocks_;  ///< in units of leaves
  std::vector<std::uint8_t> extents_;  ///< an Extent each, in a byte: there are many
};

}  // namespace certet
