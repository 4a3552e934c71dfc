#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "certet/volume_estimate.hpp"

namespace certet {
namespace {

/// A cube of lattice units.
struct Block {
  Coord3 low;
  std::int32_t side;
};

/// In cubic lattice units.
double size_of(const Block& block) { return std::pow(static_cast<double>(block.side), 3); }

/// Divides the lattice where its domain is mixed.
class Division {
 public:
  /// Whether all of a box is the same; if so it is told its size, in cubic lattice units.
  using Decide = std::function<bool(const LatticeBox& box, double size)>;

  Division(const Decide& decide, const Lattice& lattice) : decide_(decide) {
    for (std::size_t a = 0; a < 3; ++a) size_[a] = 2 * lattice.cells[a];
    low_ = lattice.origin;
    const std::int32_t longest = *std::max_element(size_.begin(), size_.end());
    std::int32_t whole = least_side;
    while (whole < longest) whole *= 2;
    smallest_ = std::max(least_side, whole / most_across);
    divide({low_, whole});
  }

  [[nodiscard]] const std::vector<Block>& mixed() const { return mixed_; }
  /// Whether the lattice reaches so far.
  [[nodiscard]] bool holds(Coord3 point) const {
    return point.x - low_.x < size_[0] && point.y - low_.y < size_[1] &&
           point.z - low_.z < size_[2];
  }

 private:
  static constexpr std::int32_t least_side = 4, most_across = 64;

  void divide(const Block& block) {
    if (!holds(block.low)) return;
    const Coord3 end = block.low + Coord3{block.side, block.side, block.side};
    if (holds(end - Coord3{1, 1, 1}) && decide_({block.low, end}, size_of(block))) return;
    if (block.side == smallest_) return mixed_.push_back(block);
    const std::int32_t half = block.side / 2;
    for (std::int32_t corner = 0; corner < 8; ++corner)
      divide({block.low + half * Coord3{corner & 1, corner >> 1 & 1, corner >> 2}, half});
  }

  const Decide& decide_;
  Coord3 low_{};
  std::array<std::int32_t, 3> size_{};
  std::int32_t smallest_ = least_side;
  std::vector<Block> mixed_;
};

/// Points that fill a cube evenly, however many are taken: multiples of the powers of
/// the plastic number of three dimensions, g^4 = g + 1.
class EvenPoints {
 public:
  /// The next one, as a share of the side along each axis.
  const std::array<double, 3>& next() {
    constexpr double g = 1.2207440846057596;
    constexpr std::array<double, 3> powers{1 / g, 1 / (g * g), 1 / (g * g * g)};
    for (std::size_t a = 0; a < 3; ++a) {
      at_[a] += powers[a];
      at_[a] -= std::floor(at_[a]);
    }
    return at_;
  }

 private:
  std::array<double, 3> at_{0.5, 0.5, 0.5};
};

/// Calls count(points, found) for the points in each mixed block; it adds to `found` how
/// many are in each of several solids.  Adds what that tells of the solids' volumes, in
/// cubic lattice units.
template <class Count>
void sample(const Division& division, std::uint64_t samples, const Context& context,
            std::vector<VolumeEstimate>& solids, const Count& count) {
  const auto blocks = static_cast<std::uint64_t>(division.mixed().size());
  const std::uint64_t each = blocks == 0 ? 0 : std::clamp<std::uint64_t>(samples / blocks, 8, 4096);
  std::vector<Coord3> points;
  std::vector<double> found(solids.size());
  EvenPoints even;
  for (const Block& block : division.mixed()) {
    stop_if_cancelled(context);
    points.clear();
    for (std::uint64_t n = 0; n < each; ++n) {
      const auto& share = even.next();
      std::array<std::int32_t, 3> whole{}, rest{};
      for (std::size_t a = 0; a < 3; ++a) {
        whole[a] = static_cast<std::int32_t>(share[a] * block.side);
        rest[a] = static_cast<std::int32_t>((share[a] * block.side - whole[a]) * steps);
      }
      const Coord3 point = block.low + Coord3{whole[0], whole[1], whole[2]};
      if (division.holds(point)) points.push_back(steps * point + Coord3{rest[0], rest[1], rest[2]});
    }
    std::ranges::fill(found, 0);
    count(std::span<const Coord3>(points), found);
    const double whole = size_of(block);
    for (std::size_t n = 0; n < solids.size(); ++n) {
      const double share = found[n] / static_cast<double>(each);
      solids[n].volume += share * whole;
      solids[n].deviation += share * (1 - share) / static_cast<double>(each) * whole * whole;
    }
  }
}

/// From lattice units to the world, and from variances to deviations.
void finish(std::vector<VolumeEstimate>& solids, const Frame& frame) {
  const double unit = std::pow(frame.size / 2, 3);
  for (auto& [volume, deviation] : solids) {
    volume *= unit;
    deviation = std::sqrt(deviation) * unit;
  }
}

}  // namespace

VolumeEstimate estimate_volume(const Domain& domain, const Lattice& lattice, const Frame& frame,
                               std::uint64_t samples, const Context& context) {
  std::vector<VolumeEstimate> solid(1);
  const Division division(
      [&](const LatticeBox& box, double size) {
        const Extent extent = domain.extent(box);
        if (extent == Extent::inside) solid[0].volume += size;
        return extent != Extent::mixed;
      },
      lattice);
  std::vector<Sign> signs;
  sample(division, samples, context, solid,
         [&](std::span<const Coord3> points, std::vector<double>& found) {
           signs.resize(points.size());
           domain.at(points, signs);
           for (const Sign sign : signs)
             found[0] += sign == Sign::plus ? 1 : sign == Sign::on_surface ? 0.5 : 0;
         });
  finish(solid, frame);
  return solid[0];
}

std::vector<VolumeEstimate> estimate_volumes(const Domain& domain, const Lattice& lattice,
                                             const Frame& frame, std::uint64_t samples,
                                             const Context& context) {
  std::vector<VolumeEstimate> solids(std::max<std::size_t>(domain.labels().size(), 1));
  const auto index = [](Material material) { return static_cast<std::size_t>(material - 1); };
  const Division division(
      [&](const LatticeBox& box, double size) {
        const std::optional<Material> material = domain.material_of(box);
        if (material && *material != 0) solids[index(*material)].volume += size;
        return material.has_value();
      },
      lattice);
  std::vector<Material> materials;
  sample(division, samples, context, solids,
         [&](std::span<const Coord3> points, std::vector<double>& found) {
           materials.resize(points.size());
           domain.materials_at(points, materials);
           for (const Material material : materials)
             if (material != 0) ++found[index(material)];
         });
  finish(solids, frame);
  return solids;
}

}  // namespace certet
