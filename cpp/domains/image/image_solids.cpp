#include "certet/image_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "certet/error.hpp"
#include "certet/moved_domain.hpp"
#include "certet/patient_axes.hpp"
#include "geometry.hpp"
#include "label_set.hpp"
#include "placement.hpp"

namespace certet {
namespace {

/// Around the voxels of which `is_in` is true, and `more` voxels on each side.
template <class IsIn>
VoxelBox box_of(const Image& image, std::int64_t more, const IsIn& is_in) {
  VoxelBox box;
  box.low.fill(std::numeric_limits<std::int64_t>::max());
  box.high.fill(-1);
  std::visit(
      [&](const auto& voxels) {
        auto voxel = voxels.data();
        for (std::int64_t z = 0; z < image.size[2]; ++z)
          for (std::int64_t y = 0; y < image.size[1]; ++y)
            for (std::int64_t x = 0; x < image.size[0]; ++x, ++voxel) {
              if (!is_in(*voxel)) continue;
              const std::array<std::int64_t, 3> at{x, y, z};
              for (std::size_t a = 0; a < 3; ++a) {
                box.low[a] = std::min(box.low[a], at[a] - more);
                box.high[a] = std::max(box.high[a], at[a] + more);
              }
            }
      },
      image.voxels);
  return box;
}

/// Of the world, around voxels with their faces.
Bounds bounds_of(const Image& image, const VoxelBox& box) {
  Bounds bounds;
  bounds.low.fill(INFINITY);
  bounds.high.fill(-INFINITY);
  for (int corner = 0; corner < 8; ++corner)
    for (std::size_t r = 0; r < 3; ++r) {
      double at = image.origin[r];
      for (std::size_t a = 0; a < 3; ++a)
        at += image.axes[r][a] * image.spacing[a] *
              (corner >> a & 1 ? static_cast<double>(box.high[a]) + 0.5
                               : static_cast<double>(box.low[a]) - 0.5);
      bounds.low[r] = std::min(bounds.low[r], at);
      bounds.high[r] = std::max(bounds.high[r], at);
    }
  return bounds;
}

/// Of labels; voxels that are none are refused.
VoxelBox box_of_labels(const Image& image, const std::vector<LabelRange>& labels) {
  check_geometry(image);
  if (!image.integral()) refuse_levels(image);
  const LabelSet set(labels);
  const VoxelBox box = box_of(
      image, 0, [&](auto voxel) { return set.contains(static_cast<std::int64_t>(voxel)); });
  if (box.high[0] < 0) refuse_unlabelled(image, labels.empty());
  return box;
}

/// Whether lattices of two frames have their points in common.
bool share_points(const Frame& one, const Frame& other) {
  if (one.size != other.size || one.axes != other.axes) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    double cells = 0;
    for (std::size_t r = 0; r < 3; ++r)
      cells += one.axes[r][a] * (other.origin[r] - one.origin[r]) / one.size;
    if (!(std::fabs(cells - std::round(cells)) < 1e-7)) return false;
  }
  return true;
}

/// A size of which no whole multiple is a voxel, so that points of the lattice are no centres of
/// voxels; about that of the lattice on which the image is wanted, or finer.
double size_elsewhere(const Image& image, double wanted) {
  double size = 1.5 * *std::ranges::min_element(image.spacing);
  while (size > 2 * wanted) size /= 2;
  return size;
}

/// `make` makes the domain of the image for an `ImageLattice`.
template <class Make>
Solid solid_of(std::shared_ptr<const Image> image, const VoxelBox& box, const Make& make) {
  const Bounds bounds = bounds_of(*image, box);
  const auto on = [image, make](const PlacedLattice& around) {
    std::shared_ptr<const PlacedDomain> own = make(ImageLattice{around.frame.size, 1});
    if (!share_points(own->frame(), around.frame))
      own = make(ImageLattice{size_elsewhere(*image, around.frame.size), 1});
    return moved_domain(std::move(own), around);
  };
  const auto own = [make](double size, std::int32_t margin) {
    const std::unique_ptr<PlacedDomain> domain = make(ImageLattice{size, margin});
    return PlacedLattice{domain->lattice(), domain->frame()};
  };
  return {bounds, on, own, true};
}

}  // namespace

Solid level_solid(std::shared_ptr<const Image> image, double level) {
  check_geometry(*image);
  static_cast<void>(level_domain(image, level, {}));  // refuses what it must
  VoxelBox box = box_of(*image, 1, [&](auto voxel) { return static_cast<double>(voxel) > level; });
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::max<std::int64_t>(box.low[a], 0);
    box.high[a] = std::min(box.high[a], image->size[a] - 1);
  }
  return solid_of(image, box, [image, level](const ImageLattice& lattice) {
    return level_domain(image, level, lattice);
  });
}

Solid label_solid(std::shared_ptr<const Image> image, std::vector<LabelRange> labels,
                  bool walls_halfway) {
  const VoxelBox box = box_of_labels(*image, labels);
  return solid_of(image, box, [=](ImageLattice lattice) {
    lattice.walls_halfway = walls_halfway;
    return label_domain(image, labels, lattice);
  });
}

Solid interface_solid(std::shared_ptr<const Image> image, std::vector<LabelRange> labels,
                      const InterfaceSmoothing& smoothing, const Context& context) {
  const VoxelBox box = box_of_labels(*image, labels);
  const auto fields = label_fields(image, std::move(labels), smoothing, context);
  return solid_of(image, box, [fields](const ImageLattice& lattice) {
    return std::unique_ptr<PlacedDomain>(interface_domain(fields, lattice));
  });
}

Image chosen_as_one(const Image& image, std::vector<LabelRange> labels) {
  if (!image.integral()) refuse_levels(image);
  const LabelSet set(std::move(labels));
  Image one = {image.name, image.size, image.spacing, image.origin, image.axes};
  one.notes = image.notes;
  one.voxels = std::visit(
      [&set](const auto& voxels) -> Voxels {
        Buffer<std::uint8_t> chosen(voxels.size());
        std::ranges::transform(voxels, chosen.begin(), [&set](auto voxel) -> std::uint8_t {
          return set.contains(static_cast<std::int64_t>(voxel)) ? 1 : 0;
        });
        return chosen;
      },
      image.voxels);
  return one;
}

Solid turned_over(const Solid& solid) {
  Solid turned{{}, {}, {}, true};
  turned.bounds = solid.bounds;
  for (std::size_t a = 0; a < 2; ++a) {
    turned.bounds.low[a] = 0.0 - solid.bounds.high[a];
    turned.bounds.high[a] = 0.0 - solid.bounds.low[a];
  }
  turned.on = [solid](const PlacedLattice& around) {
    const Frame there = turned_over(around.frame);
    return moved_domain(placed_on(solid, {around.lattice, there}), around, there);
  };
  if (solid.own)
    turned.own = [own = solid.own](double size, std::int32_t margin) {
      PlacedLattice lattice = own(size, margin);
      lattice.frame = turned_over(lattice.frame);
      return lattice;
    };
  return turned;
}

}  // namespace certet
