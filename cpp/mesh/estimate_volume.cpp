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

/// Whose a point is, of one solid or of several.
void ask(const Domain& domain, std::span<const Coord3> points, std::span<Sign> out) {
  domain.at(points, out);
}
void ask(const Domain& domain, std::span<const Coord3> points, std::span<Material> out) {
  domain.materials_at(points, out);
}
void count(Sign sign, std::span<double> found) {
  found[0] += sign == Sign::plus ? 1 : sign == Sign::on_surface ? 0.5 : 0;
}
void count(Material material, std::span<double> found) {
  if (material != 0) ++found[static_cast<std::size_t>(material - 1)];
}

/// Asks about the points of several blocks at once, for a call may cost more than a point.
/// What they tell of each solid's volume is added to it, in cubic lattice units, and of its
/// variance to its deviation.
template <class Answer>
class SampledBlocks {
 public:
  SampledBlocks(const Domain& domain, const Division& division, std::uint64_t each,
                std::span<VolumeEstimate> solids)
      : domain_(domain), division_(division), each_(each), solids_(solids), found_(solids.size()) {}

  void add(const Block& block) {
    for (std::uint64_t n = 0; n < each_; ++n) {
      const auto& share = even_.next();
      std::array<std::int32_t, 3> whole{}, rest{};
      for (std::size_t a = 0; a < 3; ++a) {
        whole[a] = static_cast<std::int32_t>(share[a] * block.side);
        rest[a] = static_cast<std::int32_t>((share[a] * block.side - whole[a]) * steps);
      }
      const Coord3 point = block.low + Coord3{whole[0], whole[1], whole[2]};
      if (division_.holds(point))
        points_.push_back(steps * point + Coord3{rest[0], rest[1], rest[2]});
    }
    pending_.push_back({block, points_.size()});
    if (points_.size() >= enough) finish();
  }

  /// Asks about the rest.
  void finish() {
    answers_.resize(points_.size());
    ask(domain_, points_, answers_);
    std::size_t begin = 0;
    for (const auto& [block, end] : pending_) {
      std::ranges::fill(found_, 0);
      for (; begin < end; ++begin) count(answers_[begin], found_);
      add_found(size_of(block));
    }
    points_.clear();
    pending_.clear();
  }

 private:
  static constexpr std::size_t enough = 4096;

  struct Pending {
    Block block;
    std::size_t end;  ///< of its points
  };

  void add_found(double whole) {
    for (std::size_t n = 0; n < solids_.size(); ++n) {
      const double share = found_[n] / static_cast<double>(each_);
      solids_[n].volume += share * whole;
      solids_[n].deviation += share * (1 - share) / static_cast<double>(each_) * whole * whole;
    }
  }

  const Domain& domain_;
  const Division& division_;
  std::uint64_t each_;
  std::span<VolumeEstimate> solids_;
  EvenPoints even_;
  std::vector<Coord3> points_;
  std::vector<Answer> answers_;
  std::vector<Pending> pending_;
  std::vector<double> found_;  ///< points of a block in each solid
};

/// Adds what is in the mixed blocks to what is in whole ones, and takes all to the world.
template <class Answer>
void sample(const Domain& domain, const Division& division, const Frame& frame,
            std::uint64_t samples, const Context& context, std::span<VolumeEstimate> solids) {
  const auto blocks = static_cast<std::uint64_t>(division.mixed().size());
  const std::uint64_t each = blocks == 0 ? 0 : std::clamp<std::uint64_t>(samples / blocks, 8, 4096);
  SampledBlocks<Answer> sampled(domain, division, each, solids);
  for (const Block& block : division.mixed()) {
    stop_if_cancelled(context);
    sampled.add(block);
  }
  sampled.finish();
  const double unit = std::pow(frame.size / 2, 3);
  for (auto& [volume, deviation] : solids) {
    volume *= unit;
    deviation = std::sqrt(deviation) * unit;
  }
}

}  // namespace

VolumeEstimate estimate_volume(const Domain& domain, const Lattice& lattice, const Frame& frame,
                               std::uint64_t samples, const Context& context) {
  std::array<VolumeEstimate, 1> solid;
  const Division division(
      [&](const LatticeBox& box, double size) {
        const Extent extent = domain.extent(box);
        if (extent == Extent::inside) solid[0].volume += size;
        return extent != Extent::mixed;
      },
      lattice);
  sample<Sign>(domain, division, frame, samples, context, solid);
  return solid[0];
}

std::vector<VolumeEstimate> estimate_volumes(const Domain& domain, const Lattice& lattice,
                                             const Frame& frame, std::uint64_t samples,
                                             const Context& context) {
  std::vector<VolumeEstimate> solids(std::max<std::size_t>(domain.labels().size(), 1));
  const Division division(
      [&](const LatticeBox& box, double size) {
        const std::optional<Material> material = domain.material_of(box);
        if (material && *material != 0)
          solids[static_cast<std::size_t>(*material - 1)].volume += size;
        return material.has_value();
      },
      lattice);
  sample<Material>(domain, division, frame, samples, context, solids);
  return solids;
}

}  // namespace certet
