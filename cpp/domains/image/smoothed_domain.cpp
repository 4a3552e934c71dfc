#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "label_set.hpp"
#include "material_table.hpp"

namespace certet {
namespace {

using Index = std::array<std::int64_t, 3>;

/// The chosen label nearest to a place in an image.
class NearestLabel {
 public:
  NearestLabel(std::shared_ptr<const Image> image, std::vector<LabelRange> labels)
      : image_(std::move(image)), set_(std::move(labels)),
        finest_(*std::min_element(image_->spacing.begin(), image_->spacing.end())) {}

  /// Searches the voxels of growing shells; of equally near voxels the first in the
  /// image counts.
  [[nodiscard]] std::int32_t operator()(const Point3& world) const {
    const Point3 at = in_voxels(world);
    Index centre;
    std::int64_t farthest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double last = static_cast<double>(image_->size[a] - 1);
      centre[a] = static_cast<std::int64_t>(std::floor(std::clamp(at[a], 0.0, last) + 0.5));
      farthest = std::max({farthest, centre[a], image_->size[a] - 1 - centre[a]});
    }
    // The voxel that the place is in is the nearest of all.
    if (const std::int64_t label = label_of(centre); set_.contains(label))
      return static_cast<std::int32_t>(label);
    Best best;
    for (std::int64_t radius = 1; radius <= farthest; ++radius) {
      if ((static_cast<double>(radius) - 0.5) * finest_ > best.distance) break;
      search_shell(centre, radius, at, best);
    }
    return best.label;
  }

  [[nodiscard]] const LabelNames& names() const { return image_->names; }

 private:
  struct Best {
    double distance = std::numeric_limits<double>::infinity();
    std::int32_t label = 0;
  };

  [[nodiscard]] Point3 in_voxels(const Point3& world) const {
    Point3 at{};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t r = 0; r < 3; ++r)
        at[a] += (world[r] - image_->origin[r]) * image_->axes[r][a];
      at[a] /= image_->spacing[a];
    }
    return at;
  }

  void search_shell(const Index& centre, std::int64_t radius, const Point3& at,
                    Best& best) const {
    Index low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max<std::int64_t>(centre[a] - radius, 0);
      high[a] = std::min(centre[a] + radius, image_->size[a] - 1);
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        const bool face = std::abs(z - centre[2]) == radius || std::abs(y - centre[1]) == radius;
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
          if (!face && x > centre[0] - radius && x < centre[0] + radius)
            x = std::min(centre[0] + radius, high[0] + 1);
          if (x <= high[0]) try_voxel({x, y, z}, at, best);
        }
      }
  }

  void try_voxel(const Index& voxel, const Point3& at, Best& best) const {
    const std::int64_t label = label_of(voxel);
    if (!set_.contains(label)) return;
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double apart = (at[a] - static_cast<double>(voxel[a])) * image_->spacing[a];
      sum += apart * apart;
    }
    const double distance = std::sqrt(sum);
    if (distance < best.distance) best = {distance, static_cast<std::int32_t>(label)};
  }

  [[nodiscard]] std::int64_t label_of(const Index& voxel) const {
    const auto at = static_cast<std::size_t>(
        (voxel[2] * image_->size[1] + voxel[1]) * image_->size[0] + voxel[0]);
    return std::visit([at](const auto& voxels) { return static_cast<std::int64_t>(voxels[at]); },
                      image_->voxels);
  }

  std::shared_ptr<const Image> image_;
  LabelSet set_;
  double finest_;
};

/// The level domain of the smoothed image, with the labels of the other one.
class SmoothedDomain final : public PlacedDomain {
 public:
  SmoothedDomain(std::unique_ptr<PlacedDomain> level, NearestLabel nearest, MaterialTable table,
                 std::uint64_t bytes)
      : level_(std::move(level)), nearest_(std::move(nearest)), table_(std::move(table)),
        bytes_(bytes) {}

  void row(Coord3 first, std::span<Sign> out) const override { level_->row(first, out); }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    level_->at(positions, out);
  }
  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    return level_->extent(box);
  }
  [[nodiscard]] const Frame& frame() const override { return level_->frame(); }
  [[nodiscard]] const Lattice& lattice() const override { return level_->lattice(); }
  [[nodiscard]] double longest_side() const override { return level_->longest_side(); }
  [[nodiscard]] std::uint64_t bytes() const override { return level_->bytes() + bytes_; }

  [[nodiscard]] std::span<const BorderBox> border() const override { return level_->border(); }
  [[nodiscard]] bool is_sampled() const override { return true; }
  [[nodiscard]] LabelNames names() const override { return nearest_.names(); }

  [[nodiscard]] std::span<const std::int32_t> labels() const override { return table_.labels(); }

  void row_materials(Coord3 first, std::span<Material> out) const override {
    level_->row_materials(first, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != 0)
        out[i] = material_at(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
  }

  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    level_->materials_at(positions, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] != 0) out[i] = material_at(positions[i]);
  }

  void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const override {
    for (std::size_t i = 0; i < tets.size(); ++i) {
      Point3 centroid{};
      for (const Coord3 corner : tets[i]) {
        const Point3 world = frame().world(corner);
        for (std::size_t a = 0; a < 3; ++a) centroid[a] += 0.25 * world[a];
      }
      out[i] = table_.of(nearest_(centroid));
    }
  }

 private:
  /// `position` is in steps, and in the solid.
  [[nodiscard]] Material material_at(Coord3 position) const {
    return table_.of(nearest_(frame().world(position)));
  }

  std::unique_ptr<PlacedDomain> level_;
  NearestLabel nearest_;
  MaterialTable table_;
  std::uint64_t bytes_;
};

std::vector<std::int32_t> chosen_labels(const Image& image, const std::vector<LabelRange>& labels) {
  std::vector<std::int32_t> chosen;
  for (const ImageRegion& region : regions_of_labels(image, labels)) chosen.push_back(region.label);
  return chosen;
}

}  // namespace

std::unique_ptr<PlacedDomain> smoothed_domain(std::shared_ptr<const Image> labelled,
                                             std::vector<LabelRange> labels,
                                             std::shared_ptr<const Image> smoothed,
                                             const ImageLattice& lattice) {
  const std::uint64_t bytes = std::visit(
      [](const auto& voxels) { return voxels.size() * sizeof(voxels[0]); }, labelled->voxels);
  MaterialTable table(chosen_labels(*labelled, labels));
  return std::make_unique<SmoothedDomain>(level_domain(std::move(smoothed), 0.5, lattice),
                                          NearestLabel(std::move(labelled), std::move(labels)),
                                          std::move(table), bytes);
}

}  // namespace certet
