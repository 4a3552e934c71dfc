#include "voxel_mask.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace certet {

VoxelMask::VoxelMask(const std::array<std::int64_t, 3>& size)
    : size_(size), words_((size[0] + 64) / 64) {
  for (std::size_t a = 0; a < 3; ++a) blocks_[a] = ((size[a] - 1) >> block_bits) + 1;
  bits_.resize(static_cast<std::size_t>(words_ * size[1] * size[2]));
}

void VoxelMask::summarise() {
  const auto blocks = static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]);
  some_.assign(blocks, 0);
  all_.assign(blocks, 1);
  bounds_.low.fill(std::numeric_limits<std::int64_t>::max());
  bounds_.high.fill(-1);
  for (std::int64_t z = 0; z < size_[2]; ++z)
    for (std::int64_t y = 0; y < size_[1]; ++y) summarise_row(y, z);
}

void VoxelMask::summarise_row(std::int64_t y, std::int64_t z) {
  const std::uint64_t* bits = row(y, z);
  const auto last_bits = static_cast<int>(((size_[0] - 1) & 7) + 1);
  const std::size_t first = block(0, y >> block_bits, z >> block_bits);
  for (std::int64_t b = 0; b < blocks_[0]; ++b) {
    const auto byte = static_cast<std::uint8_t>(bits[b >> 3] >> (8 * (b & 7)));
    const int full = b + 1 < blocks_[0] ? 0xff : (1 << last_bits) - 1;
    const std::size_t at = first + static_cast<std::size_t>(b);
    if (byte != full) all_[at] = 0;
    if (byte == 0) continue;
    some_[at] = 1;
    bounds_.low[0] = std::min(bounds_.low[0], 8 * b + std::countr_zero(byte));
    bounds_.high[0] = std::max(bounds_.high[0], 8 * b + 7 - std::countl_zero(byte));
    bounds_.low[1] = std::min(bounds_.low[1], y);
    bounds_.high[1] = std::max(bounds_.high[1], y);
    bounds_.low[2] = std::min(bounds_.low[2], z);
    bounds_.high[2] = z;
  }
}

Extent VoxelMask::extent(const VoxelBox& box) const {
  bool some = false, all = true;
  for (std::int64_t z = box.low[2] >> block_bits; z <= box.high[2] >> block_bits; ++z)
    for (std::int64_t y = box.low[1] >> block_bits; y <= box.high[1] >> block_bits; ++y)
      for (std::int64_t x = box.low[0] >> block_bits; x <= box.high[0] >> block_bits; ++x) {
        some = some || some_[block(x, y, z)];
        all = all && all_[block(x, y, z)];
        if (some && !all) return Extent::mixed;
      }
  return all ? Extent::inside : Extent::outside;
}

}  // namespace certet
