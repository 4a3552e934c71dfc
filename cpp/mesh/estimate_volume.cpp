#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "certet/volume_estimate.hpp"

namespace certet {
namespace {

/// A cube of lattice units.
struct Block {
  Coord3 low;
  std::int32_t side;
};

/// Divides the lattice where its domain is mixed.
class Division {
 public:
  Division(const Domain& domain, const Lattice& lattice) : domain_(domain) {
    for (std::size_t a = 0; a < 3; ++a) size_[a] = 2 * lattice.cells[a];
    low_ = lattice.origin;
    const std::int32_t longest = *std::max_element(size_.begin(), size_.end());
    std::int32_t whole = least_side;
    while (whole < longest) whole *= 2;
    smallest_ = std::max(least_side, whole / most_across);
    divide({low_, whole});
  }

  [[nodiscard]] const std::vector<Block>& mixed() const { return mixed_; }
  /// Of the blocks that are inside, in cubic lattice units.
  [[nodiscard]] double inside() const { return inside_; }
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
    if (holds(end - Coord3{1, 1, 1})) {
      const Extent extent = domain_.extent({block.low, end});
      if (extent == Extent::outside) return;
      if (extent == Extent::inside) {
        inside_ += std::pow(static_cast<double>(block.side), 3);
        return;
      }
    }
    if (block.side == smallest_) return mixed_.push_back(block);
    const std::int32_t half = block.side / 2;
    for (std::int32_t corner = 0; corner < 8; ++corner)
      divide({block.low + half * Coord3{corner & 1, corner >> 1 & 1, corner >> 2}, half});
  }

  const Domain& domain_;
  Coord3 low_{};
  std::array<std::int32_t, 3> size_{};
  std::int32_t smallest_ = least_side;
  std::vector<Block> mixed_;
  double inside_ = 0;
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

/// Asks about the points of several blocks at once, for a call may cost more than a point.
class SampledBlocks {
 public:
  SampledBlocks(const Domain& domain, const Division& division, std::uint64_t each)
      : domain_(domain), division_(division), each_(each) {}

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
    pending_.push_back({block.side, points_.size()});
    if (points_.size() >= enough) ask();
  }

  struct Sums {
    double volume = 0, variance = 0;  ///< in lattice units
  };
  Sums finish() {
    ask();
    return sums_;
  }

 private:
  static constexpr std::size_t enough = 4096;

  struct Pending {
    std::int32_t side;
    std::size_t end;  ///< of its points
  };

  void ask() {
    signs_.resize(points_.size());
    domain_.at(points_, signs_);
    std::size_t begin = 0;
    for (const Pending& block : pending_) {
      double found = 0;
      for (; begin < block.end; ++begin)
        found += signs_[begin] == Sign::plus ? 1 : signs_[begin] == Sign::on_surface ? 0.5 : 0;
      const double share = found / static_cast<double>(each_);
      const double whole = std::pow(static_cast<double>(block.side), 3);
      sums_.volume += share * whole;
      sums_.variance += share * (1 - share) / static_cast<double>(each_) * whole * whole;
    }
    points_.clear();
    pending_.clear();
  }

  const Domain& domain_;
  const Division& division_;
  std::uint64_t each_;
  EvenPoints even_;
  std::vector<Coord3> points_;
  std::vector<Sign> signs_;
  std::vector<Pending> pending_;
  Sums sums_;
};

}  // namespace

VolumeEstimate estimate_volume(const Domain& domain, const Lattice& lattice, const Frame& frame,
                               std::uint64_t samples, const Context& context) {
  const Division division(domain, lattice);
  const auto blocks = static_cast<std::uint64_t>(division.mixed().size());
  const std::uint64_t each = blocks == 0 ? 0 : std::clamp<std::uint64_t>(samples / blocks, 8, 4096);
  SampledBlocks sampled(domain, division, each);
  for (const Block& block : division.mixed()) {
    stop_if_cancelled(context);
    sampled.add(block);
  }
  const auto [volume, variance] = sampled.finish();
  const double unit = std::pow(frame.size / 2, 3);
  return {(division.inside() + volume) * unit, std::sqrt(variance) * unit};
}

}  // namespace certet
