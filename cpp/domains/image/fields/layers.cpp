#include "layers.hpp"

#include <algorithm>

namespace certet::fields {

Layers::Layers(const MaterialImage& image, std::size_t normal,
               const std::array<std::int64_t, 3>& low, const std::array<std::int64_t, 3>& high)
    : normal_(normal), fast_(normal == 0 ? 1 : 0), slow_(normal == 2 ? 1 : 2), low_(low) {
  for (std::size_t a = 0; a < 3; ++a) counts_[a] = high[a] - low[a] + 1;
  strides_[fast_] = 1;
  strides_[slow_] = counts_[fast_];
  strides_[normal_] = counts_[fast_] * counts_[slow_];
  voxels_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]), beyond);
  std::array<std::int64_t, 3> first, last;  // of the image
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = std::max<std::int64_t>(low[a], 0);
    last[a] = std::min(high[a], image.size()[a] - 1);
  }
  for (std::int64_t z = first[2]; z <= last[2]; ++z)
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      const std::int64_t at = (first[0] - low[0]) * strides_[0] + (y - low[1]) * strides_[1] +
                              (z - low[2]) * strides_[2];
      image.read_row({first[0], y, z}, last[0] - first[0] + 1,
                     &voxels_[static_cast<std::size_t>(at)], strides_[0]);
    }
}

std::array<std::int64_t, 3> Layers::voxel(std::int64_t layer, std::int64_t in_layer) const {
  std::array<std::int64_t, 3> voxel;
  voxel[normal_] = layer;
  voxel[fast_] = low_[fast_] + in_layer % counts_[fast_];
  voxel[slow_] = low_[slow_] + in_layer / counts_[fast_];
  return voxel;
}

}  // namespace certet::fields
