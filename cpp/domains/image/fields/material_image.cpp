#include "material_image.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "certet/error.hpp"
#include "geometry.hpp"

namespace certet::fields {
namespace {

/// Materials of voxels, which come in runs of one label.
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

void refuse_unless_labels(const Image& image, const LabelSet& set) {
  std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        if constexpr (std::is_floating_point_v<T>) refuse_levels(image);
        else refuse_wide_labels(image, voxels, set);
      },
      image.voxels);
}

std::vector<std::int32_t> labels_of(const std::vector<ImageRegion>& regions) {
  std::vector<std::int32_t> labels;
  for (const ImageRegion& region : regions) labels.push_back(region.label);
  return labels;
}

}  // namespace

MaterialImage::MaterialImage(std::shared_ptr<const Image> image, std::vector<LabelRange> labels)
    : image_(std::move(image)), set_(labels), table_({}) {
  check_geometry(*image_);
  refuse_unless_labels(*image_, set_);
  const bool all = labels.empty();
  const std::vector<ImageRegion> regions = regions_of_labels(*image_, std::move(labels));
  if (regions.empty()) refuse_unlabelled(*image_, all);
  table_ = MaterialTable(labels_of(regions));
  for (const ImageRegion& region : regions) voxels_.push_back(region.voxels);
  find_bounds();
}

void MaterialImage::find_bounds() {
  bounds_.low.fill(std::numeric_limits<std::int64_t>::max());
  bounds_.high.fill(-1);
  const auto& [nx, ny, nz] = size();
  const auto add_row = [&](std::int64_t first, std::int64_t last, std::int64_t y,
                           std::int64_t z) {
    bounds_.low = {std::min(bounds_.low[0], first), std::min(bounds_.low[1], y),
                   std::min(bounds_.low[2], z)};
    bounds_.high = {std::max(bounds_.high[0], last), std::max(bounds_.high[1], y),
                    std::max(bounds_.high[2], z)};
  };
  std::visit(
      [&, width = nx, rows = ny, layers = nz](const auto& voxels) {
        MaterialOfVoxel material(set_, table_);
        auto voxel = voxels.data();
        for (std::int64_t z = 0; z < layers; ++z)
          for (std::int64_t y = 0; y < rows; ++y, voxel += width) {
            const auto chosen = [&](std::int64_t x) {
              return material(static_cast<std::int64_t>(voxel[x])) != 0;
            };
            std::int64_t first = 0, last = width - 1;
            while (first < width && !chosen(first)) ++first;
            if (first == width) continue;
            while (!chosen(last)) --last;
            add_row(first, last, y, z);
          }
      },
      image_->voxels);
}

void MaterialImage::append_runs(const VoxelCube& cube, std::vector<MaterialRun>& runs) const {
  const auto within = [&](std::size_t axis, std::int64_t at) {
    return std::clamp<std::int64_t>(cube.low[axis] + at, 0, size()[axis] - 1);
  };
  const std::int64_t first = within(0, 0), last = within(0, cube.width - 1);
  // How many more there are of the outermost ones.
  const auto before = static_cast<std::int32_t>(first - cube.low[0]);
  const auto behind = static_cast<std::int32_t>(cube.low[0] + cube.width - 1 - last);
  std::visit(
      [&](const auto& voxels) {
        MaterialOfVoxel material(set_, table_);
        for (std::int64_t z = 0; z < cube.width; ++z)
          for (std::int64_t y = 0; y < cube.width; ++y) {
            const auto row =
                voxels.data() + (within(2, z) * size()[1] + within(1, y)) * size()[0];
            const std::size_t start = runs.size();
            for (auto from = row + first; from != row + last + 1;) {
              const auto to = std::find_if(from, row + last + 1,
                                           [from](auto voxel) { return voxel != *from; });
              runs.push_back({material(static_cast<std::int64_t>(*from)),
                              static_cast<std::int32_t>(to - from)});
              from = to;
            }
            runs[start].length += before;
            runs.back().length += behind;
          }
      },
      image_->voxels);
}

void MaterialImage::read_row(const std::array<std::int64_t, 3>& first, std::int64_t count,
                             Material* out, std::int64_t stride) const {
  std::visit(
      [&](const auto& voxels) {
        MaterialOfVoxel material(set_, table_);
        const auto row = voxels.data() + (first[2] * size()[1] + first[1]) * size()[0] + first[0];
        Material last = material(static_cast<std::int64_t>(row[0]));
        for (std::int64_t x = 0; x < count; ++x) {
          if (x > 0 && row[x] != row[x - 1]) last = material(static_cast<std::int64_t>(row[x]));
          out[x * stride] = last;
        }
      },
      image_->voxels);
}

std::uint64_t MaterialImage::bytes() const {
  const std::uint64_t voxels = std::visit(
      [](const auto& buffer) { return buffer.size() * sizeof(buffer[0]); }, image_->voxels);
  return voxels + table_.bytes() + voxels_.size() * sizeof(voxels_[0]);
}

}  // namespace certet::fields
