#pragma once
/// \file
/// An image of labels as one of materials.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
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

/// So many voxels one after the other, no more than one row.
struct MaterialRun {
  Material material;
  std::int32_t length;
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

  /// Appends runs of one material each in the voxels of a cube, the first axis running fastest;
  /// beyond the image its outermost voxels go on.
  void append_runs(const VoxelCube& cube, std::vector<MaterialRun>& runs) const;

  /// Materials of some voxels of the image along its first axis, each written `stride` elements
  /// behind the one before.
  void read_row(const std::array<std::int64_t, 3>& first, std::int64_t count, Material* out,
                std::int64_t stride) const;

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
