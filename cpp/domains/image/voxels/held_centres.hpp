#pragma once
/// \file
/// Which centres of voxels a tetrahedron holds, exactly.

#include <algorithm>
#include <array>
#include <cstdint>

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

using FineCorners = std::array<FinePoint, 4>;

/// Six times its volume, of the sign that the order of its corners gives it.
inline WideProduct volume(const FineCorners& corners) {
  const HalfSpace base(corners[0], corners[1], corners[2]);
  return base.depth(corners[3]) - base.depth(corners[0]);
}

/// The voxels that a tetrahedron may hold the centres of, of those in a range.
inline VoxelRange voxels_around(const FineCorners& corners, const VoxelRange& within) {
  VoxelRange result = within;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax({corners[0][a], corners[1][a], corners[2][a], corners[3][a]});
    result.first[a] = std::max(result.first[a], (low + one_voxel - 1) >> 20);
    result.last[a] = std::min(result.last[a], high >> 20);
  }
  return result;
}

/// A tetrahedron among the voxels; it has a volume, and its corners may be in any order.
class TetAmongVoxels {
 public:
  explicit TetAmongVoxels(const FineCorners& corners) : TetAmongVoxels(corners, volume(corners) < 0) {}

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
  TetAmongVoxels(const FineCorners& p, bool turned)
      : sides_{HalfSpace(p[0], p[turned ? 2 : 1], p[turned ? 1 : 2]),
               HalfSpace(p[0], p[turned ? 1 : 3], p[turned ? 3 : 1]),
               HalfSpace(p[0], p[turned ? 3 : 2], p[turned ? 2 : 3]),
               HalfSpace(p[1], p[turned ? 2 : 3], p[turned ? 3 : 2])} {}

  std::array<HalfSpace, 4> sides_;
};

}  // namespace certet
