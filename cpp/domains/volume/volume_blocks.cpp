#include "volume_blocks.hpp"

#include <cmath>

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
  extents_.resize(static_cast<std::size_t>(blocks_.volume()));
  const auto accessor = grid.getConstAccessor();
  std::size_t at = 0;
  for (int z = blocks_.min()[2]; z <= blocks_.max()[2]; ++z)
    for (int y = blocks_.min()[1]; y <= blocks_.max()[1]; ++y)
      for (int x = blocks_.min()[0]; x <= blocks_.max()[0]; ++x) {
        const openvdb::Coord voxel(x * dimension, y * dimension, z * dimension);
        const auto* const leaf = accessor.probeConstLeaf(voxel);
        extents_[at++] = leaf != nullptr ? extent_of(*leaf, level, sign)
                                         : extent_of(accessor.getValue(voxel), level, sign);
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
  const Extent first = extents_[block(asked.min())];
  for (auto at = asked.begin(); at; ++at)
    if (extents_[block(*at)] != first) return Extent::mixed;
  return first;
}

}  // namespace certet
