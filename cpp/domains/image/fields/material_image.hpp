#pragma once
/// \file
/// An image of labels as one of materials.

#include <array>
#include <cstdint>
#include <memory>
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "certet/domain.hpp"
#include "certet/image.hpp"
#include "label_set.hpp"
#include "material_table.hpp"
#include "placement.hpp"

namespace certet::fields {

/// A cube of voxels; `low` may lie before the image and `width` reach beyond it.
struct VoxelCube {
  std::array<std::int64_t, 3> low;
  std::int64_t width;
};

/// From the label of a voxel to its material.  The last one is kept.
class MaterialOfVoxel {
 public:
  MaterialOfVoxel(const LabelSet& set, const MaterialTable& table) : set_(set), table_(table) {}

  Material operator()(std::int64_t label) {
    if (label != last_) {
      last_ = label;
      found_ = set_.contains(label) ? table_.of(label) : 0;
    }
    return found_;
  }

 private:
  const LabelSet& set_;
  const MaterialTable& table_;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::min();
  Material found_ = 0;
};

class MaterialImage {
 public:
  /// \throws Error as `label_domain`.
  MaterialImage(std::shared_ptr<const Image> image, std::vector<LabelRange> labels);

  [[nodiscard]] const Image& image() const { return *image_; }
  [[nodiscard]] const std::array<std::int64_t, 3>& size() const { return image_->size; }
  /// Of the materials from 1 on, ascending.
  [[nodiscard]] std::span<const std::int32_t> labels() const { return table_.labels(); }
  /// How many voxels each of the materials from 1 on has.
  [[nodiscard]] std::span<const std::uint64_t> voxels() const { return voxels_; }
  /// Of all voxels that have a material.
  [[nodiscard]] const VoxelBox& bounds() const { return bounds_; }

  /// Materials of the voxels of a cube, the first axis running fastest; beyond the
  /// image its outermost voxels go on.  `out` has width^3 elements.
  void read(const VoxelCube& cube, std::span<Material> out) const;

  /// Calls use(material), where material(voxel) is that of a voxel in the image.
  template <class Use>
  void with_materials(const Use& use) const {
    std::visit(
        [&](const auto& voxels) {
          MaterialOfVoxel of(set_, table_);
          use([&](const std::array<std::int64_t, 3>& v) {
            const auto at = static_cast<std::size_t>((v[2] * size()[1] + v[1]) * size()[0] + v[0]);
            return of(static_cast<std::int64_t>(voxels[at]));
          });
        },
        image_->voxels);
  }

  [[nodiscard]] std::uint64_t bytes() const;

 private:
  void find_bounds();

  std::shared_ptr<const Image> image_;
  LabelSet set_;
  MaterialTable table_;
  std::vector<std::uint64_t> voxels_;
  VoxelBox bounds_{};
};

}  // namespace certet::fields
