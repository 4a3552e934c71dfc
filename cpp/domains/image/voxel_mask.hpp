#pragma once
/// \file
/// Which voxels belong to a solid: a bit for each, and a summary of blocks.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "placement.hpp"

namespace certet {

/// Bits of voxels, as stored.  Every row ends with at least one bit that is
/// never set, number `outside()`, so that a table of positions can send those
/// beyond the image there and sampling needs no branch.
class VoxelMask {
 public:
  explicit VoxelMask(const std::array<std::int64_t, 3>& size);

  [[nodiscard]] std::int64_t outside() const { return size_[0]; }
  [[nodiscard]] std::uint64_t* row(std::int64_t y, std::int64_t z) {
    return bits_.data() + static_cast<std::size_t>((z * size_[1] + y) * words_);
  }
  [[nodiscard]] const std::uint64_t* row(std::int64_t y, std::int64_t z) const {
    return bits_.data() + static_cast<std::size_t>((z * size_[1] + y) * words_);
  }
  static bool test(const std::uint64_t* row, std::int64_t x) {
    return (row[x >> 6] >> (x & 63)) & 1;
  }
  [[nodiscard]] bool test(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return test(row(y, z), x);
  }

  /// The bit of a voxel is number x + row_bits() (y + size_y z) of all.
  [[nodiscard]] std::int64_t row_bits() const { return 64 * words_; }
  [[nodiscard]] bool test(std::int64_t bit) const { return test(bits_.data(), bit); }

  /// To be called once, when all bits are set.
  void summarise();
  /// The smallest box that holds all set bits.
  [[nodiscard]] const VoxelBox& bounds() const { return bounds_; }
  /// What is known of all voxels of a box; exact for boxes of whole blocks.
  [[nodiscard]] Extent extent(const VoxelBox& box) const;

  [[nodiscard]] std::uint64_t bytes() const {
    return bits_.size() * sizeof(std::uint64_t) + some_.size() + all_.size();
  }

 private:
  static constexpr int block_bits = 3;  ///< blocks of 8 x 8 x 8 voxels

  [[nodiscard]] std::size_t block(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * blocks_[1] + y) * blocks_[0] + x);
  }
  void summarise_row(std::int64_t y, std::int64_t z);

  std::array<std::int64_t, 3> size_, blocks_;
  std::int64_t words_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint8_t> some_, all_;  ///< of each block
  VoxelBox bounds_;
};

}  // namespace certet
