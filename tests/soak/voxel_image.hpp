#pragma once
/// \file
/// The image that a random trial paints.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "certet/image.hpp"

namespace soak {

/// Labels of voxels; the first axis runs fastest.
struct VoxelImage {
  std::array<std::int64_t, 3> size{};
  certet::Point3 spacing{};
  std::vector<std::uint8_t> voxels;

  /// All voxels have label 0.
  void clear() { voxels.assign(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0); }
  [[nodiscard]] std::size_t number(const std::array<std::int64_t, 3>& voxel) const {
    return static_cast<std::size_t>((voxel[2] * size[1] + voxel[1]) * size[0] + voxel[0]);
  }
  [[nodiscard]] bool holds(const std::array<std::int64_t, 3>& voxel) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (voxel[a] < 0 || voxel[a] >= size[a]) return false;
    return true;
  }

  [[nodiscard]] certet::Image image() const {
    certet::Image made;
    made.name = "soak";
    made.size = size;
    made.spacing = spacing;
    certet::Buffer<std::uint8_t> copy(voxels.size());
    std::ranges::copy(voxels, copy.begin());
    made.voxels = std::move(copy);
    return made;
  }
};

}  // namespace soak
