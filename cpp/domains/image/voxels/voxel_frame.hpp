#pragma once
/// \file
/// Points of the world in fractions of an image's voxels.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "certet/image.hpp"
#include "geometry.hpp"

namespace certet {

/// A position along the voxel axes, in 2^-20 voxels; the centre of voxel (i,j,k) is at
/// (i,j,k) * one_voxel.
using FinePoint = std::array<std::int64_t, 3>;
inline constexpr std::int64_t one_voxel = std::int64_t{1} << 20;
/// So many voxels from the first, positions are those that products of three fit 128 bits of.
inline constexpr std::int64_t farthest_voxel = std::int64_t{1} << 18;

/// From the world to the voxels of an image.
class VoxelFrame {
 public:
  explicit VoxelFrame(const Image& image) : origin_(image.origin) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t r = 0; r < 3; ++r) rows_[a][r] = image.axes[r][a] / image.spacing[a];
  }

  /// In voxels, not rounded.
  [[nodiscard]] Point3 voxels(const Point3& world) const {
    const Point3 from{world[0] - origin_[0], world[1] - origin_[1], world[2] - origin_[2]};
    return {dot(rows_[0], from), dot(rows_[1], from), dot(rows_[2], from)};
  }

  /// None for what is not finite or too far away.
  [[nodiscard]] std::optional<FinePoint> fine(const Point3& world) const {
    const Point3 at = voxels(world);
    FinePoint result{};
    for (std::size_t a = 0; a < 3; ++a) {
      if (!(std::abs(at[a]) <= static_cast<double>(farthest_voxel))) return std::nullopt;
      result[a] = std::llround(at[a] * static_cast<double>(one_voxel));
    }
    return result;
  }

 private:
  Point3 origin_;
  std::array<Point3, 3> rows_{};
};

}  // namespace certet
