#include "volume_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "certet/error.hpp"

namespace certet {
namespace {

Extent extent_of(float value, double level, double sign) {
  return sign * double{value} < sign * level   ? Extent::inside
         : sign * double{value} > sign * level ? Extent::outside
                                               : Extent::mixed;
}

Extent extent_of(const openvdb::FloatTree::LeafNodeType& leaf, double level, double sign) {
  const Extent first = extent_of(leaf.getValue(0), level, sign);
  for (openvdb::Index i = 1; i < leaf.SIZE; ++i)
    if (extent_of(leaf.getValue(i), level, sign) != first) return Extent::mixed;
  return first;
}

constexpr std::int64_t most_blocks = std::int64_t{1} << 30;

}  // namespace

VolumeBlocks::VolumeBlocks(const openvdb::FloatGrid& grid, double level, double sign)
    : blocks_(blocks_of(grid.evalActiveVoxelBoundingBox())) {
  const openvdb::Coord count = blocks_.extents();
  if (double(count[0]) * count[1] * count[2] > double(most_blocks))
    throw Error(ErrorCode::too_large, "the volume spans too many voxels");
  // Most blocks of a sparse volume are nowhere in its tree, and most tiles as what is there.
  const Extent elsewhere = extent_of(grid.background(), level, sign);
  extents_.assign(static_cast<std::size_t>(blocks_.volume()), static_cast<std::uint8_t>(elsewhere));
  auto tile = grid.tree().cbeginValueAll();
  for (tile.setMaxDepth(decltype(tile)::LEAF_DEPTH - 1); tile; ++tile)
    if (const Extent extent = extent_of(tile.getValue(), level, sign); extent != elsewhere)
      fill(tile.getBoundingBox(), extent);
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
    fill(leaf->getNodeBoundingBox(), extent_of(*leaf, level, sign));
}

void VolumeBlocks::fill(const openvdb::CoordBBox& voxels, Extent extent) {
  openvdb::CoordBBox part = blocks_of(voxels);
  part.intersect(blocks_);
  if (part.empty()) return;
  const auto count = static_cast<std::size_t>(part.extents()[0]);
  const auto whole = static_cast<std::size_t>(blocks_.extents()[0]);
  for (int z = part.min()[2]; z <= part.max()[2]; ++z) {
    std::size_t row = block({part.min()[0], part.min()[1], z});
    for (int y = part.min()[1]; y <= part.max()[1]; ++y, row += whole)
      std::fill_n(extents_.data() + row, count, static_cast<std::uint8_t>(extent));
  }
}

openvdb::CoordBBox VolumeBlocks::blocks_of(const openvdb::CoordBBox& voxels) const {
  const auto down = [](const openvdb::Coord& c) {
    return openvdb::Coord(c[0] >> 3, c[1] >> 3, c[2] >> 3);
  };
  static_assert(dimension == 8);
  return {down(voxels.min()), down(voxels.max())};
}

std::size_t VolumeBlocks::block(const openvdb::Coord& at) const {
  const openvdb::Coord from = at - blocks_.min(), count = blocks_.extents();
  return (static_cast<std::size_t>(from[2]) * static_cast<std::size_t>(count[1]) +
          static_cast<std::size_t>(from[1])) * static_cast<std::size_t>(count[0]) +
         static_cast<std::size_t>(from[0]);
}

Extent VolumeBlocks::extent(const openvdb::CoordBBox& voxels) const {
  const openvdb::CoordBBox asked = blocks_of(voxels);
  // Beyond there may be tiles that are inactive and inside.
  if (!blocks_.isInside(asked)) return Extent::mixed;
  const std::uint8_t first = extents_[block(asked.min())];
  for (auto at = asked.begin(); at; ++at)
    if (extents_[block(*at)] != first) return Extent::mixed;
  return static_cast<Extent>(first);
}

}  // namespace certet
