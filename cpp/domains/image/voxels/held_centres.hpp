#pragma once
/// \file
/// Which centres of voxels a tetrahedron holds, exactly.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "voxel_frame.hpp"

namespace certet {

/// Products of three differences of positions.
__extension__ using WideProduct = __int128;

/// The side of a tetrahedron's face on which the tetrahedron is.
class HalfSpace {
 public:
  HalfSpace() = default;
  /// Inside is where (b - a) x (c - a) points to.
  HalfSpace(const FinePoint& a, const FinePoint& b, const FinePoint& c) {
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      normal_[x] = WideProduct{b[y] - a[y]} * (c[z] - a[z]) - WideProduct{b[z] - a[z]} * (c[y] - a[y]);
    }
    for (std::size_t x = 0; x < 3; ++x) offset_ -= normal_[x] * a[x];
    // A point on the plane belongs to where a step along the first axis leads that leaves it.
    for (const WideProduct along : normal_) {
      if (along == 0) continue;
      if (along > 0) offset_ += 1;
      break;
    }
  }

  /// Positive for what belongs to it.
  [[nodiscard]] WideProduct depth(const FinePoint& p) const {
    return normal_[0] * p[0] + normal_[1] * p[1] + normal_[2] * p[2] + offset_;
  }
  /// What a step of one voxel along the first axis adds.
  [[nodiscard]] WideProduct slope() const { return normal_[0] * one_voxel; }

 private:
  std::array<WideProduct, 3> normal_{};
  WideProduct offset_ = 0;
};

/// A range of voxels along each axis: first to last, both in it.
struct VoxelRange {
  std::array<std::int64_t, 3> first{}, last{};
  [[nodiscard]] bool empty() const {
    return first[0] > last[0] || first[1] > last[1] || first[2] > last[2];
  }
};

/// A tetrahedron among the voxels.
class TetAmongVoxels {
 public:
  /// None of a tetrahedron without a volume; the order of its corners does not matter.
  static std::optional<TetAmongVoxels> of(std::array<FinePoint, 4> corners) {
    const HalfSpace base(corners[0], corners[1], corners[2]);
    const WideProduct depth = base.depth(corners[3]) - base.depth(corners[0]);
    if (depth == 0) return std::nullopt;
    if (depth < 0) std::swap(corners[0], corners[1]);
    return TetAmongVoxels(corners);
  }

  /// The voxels that it may hold the centres of, of those in a box.
  [[nodiscard]] VoxelRange box(const VoxelRange& within) const {
    VoxelRange result = within;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax({corners_[0][a], corners_[1][a], corners_[2][a], corners_[3][a]});
      result.first[a] = std::max(result.first[a], (low + one_voxel - 1) >> 20);
      result.last[a] = std::min(result.last[a], high >> 20);
    }
    return result;
  }

  /// Calls take(i, j, k) for every voxel of a box whose centre it holds.
  template <class Take>
  void held(const VoxelRange& box, const Take& take) const {
    for (std::int64_t k = box.first[2]; k <= box.last[2]; ++k)
      for (std::int64_t j = box.first[1]; j <= box.last[1]; ++j) {
        const FinePoint start{box.first[0] * one_voxel, j * one_voxel, k * one_voxel};
        std::array<WideProduct, 4> depth{};
        for (std::size_t f = 0; f < 4; ++f) depth[f] = sides_[f].depth(start);
        for (std::int64_t i = box.first[0]; i <= box.last[0]; ++i) {
          if (std::ranges::all_of(depth, [](WideProduct d) { return d > 0; })) take(i, j, k);
          for (std::size_t f = 0; f < 4; ++f) depth[f] += sides_[f].slope();
        }
      }
  }

 private:
  /// Of a positive volume.
  explicit TetAmongVoxels(const std::array<FinePoint, 4>& p)
      : corners_(p), sides_{HalfSpace(p[0], p[1], p[2]), HalfSpace(p[0], p[3], p[1]),
                            HalfSpace(p[0], p[2], p[3]), HalfSpace(p[1], p[3], p[2])} {}

  std::array<FinePoint, 4> corners_;
  std::array<HalfSpace, 4> sides_;
};

}  // namespace certet
