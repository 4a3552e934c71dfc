#pragma once
/// \file
/// Some layers of voxels as materials, and a margin.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "fields/material_image.hpp"

namespace certet::fields {

/// Beyond the image.
inline constexpr Material beyond = -1;

/// Voxels of `low` to `high`, both included, along each axis; layer by layer of one axis, and
/// in each the lower of the other two axes runs fastest.
class Layers {
 public:
  Layers(const MaterialImage& image, std::size_t normal, const std::array<std::int64_t, 3>& low,
         const std::array<std::int64_t, 3>& high);

  /// The first voxel of a layer, by its number along the normal.
  [[nodiscard]] const Material* layer(std::int64_t number) const {
    return &voxels_[static_cast<std::size_t>((number - low_[normal_]) * strides_[normal_])];
  }
  [[nodiscard]] std::int64_t layer_size() const { return strides_[normal_]; }
  /// From one voxel to the next along an axis.
  [[nodiscard]] std::int64_t stride(std::size_t axis) const { return strides_[axis]; }
  [[nodiscard]] std::array<std::int64_t, 3> voxel(std::int64_t layer, std::int64_t in_layer) const;

 private:
  std::size_t normal_, fast_, slow_;  ///< axes
  std::array<std::int64_t, 3> low_, counts_{}, strides_{};
  std::vector<Material> voxels_;
};

}  // namespace certet::fields
