#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "certet/bounded_function.hpp"
#include "certet/combined_solids.hpp"
#include "certet/error.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "volume_blocks.hpp"
#include "volume_state.hpp"

namespace certet {
namespace {

using openvdb::Vec3d;

/// Inside is where sign * value < sign * level.
struct Side {
  double level, sign;

  Side(const Volume::State& volume, std::optional<double> chosen) {
    const bool distance = volume.grid->getGridClass() == openvdb::GRID_LEVEL_SET;
    if (!distance && !chosen)
      throw Error(ErrorCode::bad_option,
                  "'" + volume.name + "' is not a level set: choose a level with --iso");
    level = chosen.value_or(0);
    if (!std::isfinite(level))
      throw Error(ErrorCode::bad_option, "the level must be a finite number");
    const double band = std::abs(double{volume.grid->background()});
    if (distance && std::abs(level) >= band)
      throw Error(ErrorCode::bad_option, "the level is beyond the narrow band of '" +
                                             volume.name + "', which is " +
                                             std::to_string(band) + " wide");
    sign = distance ? 1 : -1;
  }

  [[nodiscard]] Sign of(double value) const { return sign_of_level(sign * (value - level)); }
};

/// The box of world points around a box of voxels.
openvdb::BBoxd in_world(const openvdb::FloatGrid& grid, const openvdb::CoordBBox& voxels) {
  openvdb::BBoxd box;
  for (int corner = 0; corner < 8; ++corner)
    box.expand(grid.indexToWorld(Vec3d(corner & 1 ? voxels.max()[0] : voxels.min()[0],
                                       corner & 2 ? voxels.max()[1] : voxels.min()[1],
                                       corner & 4 ? voxels.max()[2] : voxels.min()[2])));
  return box;
}

/// The file has a transform's inverse too, which may be that of another.
void check_inverse(const Volume::State& volume, const openvdb::CoordBBox& voxels) {
  for (const openvdb::Coord& corner : {voxels.min(), voxels.max()}) {
    const Vec3d at = corner.asVec3d();
    const double error = (volume.grid->worldToIndex(volume.grid->indexToWorld(at)) - at).length();
    if (!(error <= 0.5 + 1e-6 * at.length()))
      throw Error(ErrorCode::bad_input, "'" + volume.name + "' has a transform that is not the "
                                            "inverse of its inverse");
  }
}

/// Voxels are counted by 32 bits.
void check_reach(const Volume::State& volume, const Frame& frame, const Lattice& lattice) {
  constexpr double farthest = 1 << 30;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::size_t a) {
      return frame.origin[a] + (corner >> a & 1 ? 1 : -1) * frame.size / 2 * lattice.cells[a];
    };
    const Vec3d at = volume.grid->worldToIndex(Vec3d(side(0), side(1), side(2)));
    for (int a = 0; a < 3; ++a)
      if (!(std::abs(at[a]) <= farthest))
        throw Error(ErrorCode::too_large,
                    "the lattice reaches too far beyond the voxels of '" + volume.name + "'");
  }
}

/// The box of the active voxels in the world.
openvdb::BBoxd active_box(const Volume::State& volume) {
  openvdb::CoordBBox voxels = volume.grid->evalActiveVoxelBoundingBox();
  if (voxels.empty())
    throw Error(ErrorCode::empty_domain, "'" + volume.name + "' has no active voxels");
  voxels.expand(1);  // interpolation reaches so far
  check_inverse(volume, voxels);
  return in_world(*volume.grid, voxels);
}

Point3 as_point(const Vec3d& v) { return {v[0], v[1], v[2]}; }

/// Frame and lattice.
struct Place {
  Frame frame;
  Lattice lattice;
  double longest_side = 0;

  /// Of others.
  Place(const Volume::State& volume, const PlacedLattice& around)
      : frame(around.frame), lattice(around.lattice) {
    const openvdb::BBoxd box = active_box(volume);
    longest_side = box.extents()[box.maxExtent()];
    check_reach(volume, frame, lattice);
  }

  Place(const Volume::State& volume, const VolumeLattice& choice) {
    const openvdb::BBoxd box = active_box(volume);
    const Vec3d voxel = volume.grid->voxelSize();
    frame.size = checked_size(choice.size == 0 ? std::min({voxel[0], voxel[1], voxel[2]})
                                               : choice.size);
    checked_margin(choice.margin);
    longest_side = box.extents()[box.maxExtent()];
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      frame.origin[axis] = box.getCenter()[a];
      // Even, so that lattice point (0,0,0) is in the middle.
      lattice.cells[axis] = checked_cells(
          2 * (std::ceil(box.extents()[a] / (2 * frame.size)) + choice.margin));
    }
    lattice.origin = {-lattice.cells[0], -lattice.cells[1], -lattice.cells[2]};
    check_reach(volume, frame, lattice);
  }
};

class VolumeDomain final : public PlacedDomain {
 public:
  VolumeDomain(std::shared_ptr<const Volume::State> volume, const Side& side,
               const Place& place)
      : volume_(std::move(volume)),
        side_(side),
        place_(place),
        blocks_(*volume_->grid, side.level, side.sign) {}

  [[nodiscard]] const Frame& frame() const override { return place_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return place_.lattice; }
  [[nodiscard]] double longest_side() const override { return place_.longest_side; }
  [[nodiscard]] std::uint64_t bytes() const override {
    return volume_->grid->memUsage() + blocks_.bytes();
  }
  [[nodiscard]] bool is_sampled() const override { return true; }

  void row(Coord3 first, std::span<Sign> out) const override {
    Sampler sampler(*this);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = sampler(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    Sampler sampler(*this);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sampler(positions[i]);
  }

  [[nodiscard]] Extent extent(const LatticeBox& box) const override {
    openvdb::BBoxd reach;
    for (int corner = 0; corner < 8; ++corner)
      reach.expand(in_voxels(steps * Coord3{corner & 1 ? box.high.x : box.low.x,
                                            corner & 2 ? box.high.y : box.low.y,
                                            corner & 4 ? box.high.z : box.low.z}));
    // Interpolation takes the next voxel too, and rounding may take another.
    return blocks_.extent({openvdb::Coord::floor(reach.min() - 1e-6),
                           openvdb::Coord::floor(reach.max() + 1e-6).offsetBy(1)});
  }

 private:
  [[nodiscard]] Vec3d in_voxels(Coord3 position) const {
    const Point3 world = place_.frame.world(position);
    return volume_->grid->worldToIndex(Vec3d(world[0], world[1], world[2]));
  }

  /// For one thread at a time: it remembers where it read last.
  class Sampler {
   public:
    explicit Sampler(const VolumeDomain& domain)
        : domain_(domain), accessor_(domain.volume_->grid->getConstAccessor()) {}

    Sign operator()(Coord3 position) {
      const Vec3d at = domain_.in_voxels(position);
      const openvdb::Coord low = openvdb::Coord::floor(at);
      double value = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const openvdb::Coord voxel = low.offsetBy(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1;
        for (int a = 0; a < 3; ++a)
          weight *= 1 - std::abs(at[a] - voxel[static_cast<unsigned>(a)]);
        value += weight * double{accessor_.getValue(voxel)};
      }
      return domain_.side_.of(value);
    }

   private:
    const VolumeDomain& domain_;
    openvdb::FloatGrid::ConstAccessor accessor_;
  };

  std::shared_ptr<const Volume::State> volume_;
  Side side_;
  Place place_;
  VolumeBlocks blocks_;
};

}  // namespace

std::unique_ptr<PlacedDomain> volume_domain(const Volume& volume, std::optional<double> level,
                                            const VolumeLattice& lattice) {
  const Side side(volume.state(), level);
  return std::make_unique<VolumeDomain>(volume.shared(), side, Place(volume.state(), lattice));
}

Solid volume_solid(const Volume& volume, std::optional<double> level) {
  const Side side(volume.state(), level);
  const openvdb::BBoxd box = active_box(volume.state());
  const Bounds bounds{as_point(box.min()), as_point(box.max())};
  const Solid everywhere{bounds, [state = volume.shared(), side](const PlacedLattice& around) {
                           return std::make_shared<VolumeDomain>(state, side,
                                                                 Place(*state, around));
                         }};
  return everywhere & function_solid([](const Point3&) { return -1.0; }, bounds);
}

}  // namespace certet
