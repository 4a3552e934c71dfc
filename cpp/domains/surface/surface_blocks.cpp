#include "surface_blocks.hpp"

#include <algorithm>
#include <cmath>

namespace certet {
namespace {

constexpr std::int64_t most_blocks = std::int64_t{1} << 26;

/// The plane of a triangle, and how near to it the centre of a block may be, at
/// most, if it meets the block.  Rounding is covered by a part in 10^9.
class Slab {
 public:
  Slab(const exact::Corners& t, double side)
      : through_{double(t[0].x), double(t[0].y), double(t[0].z)} {
    const exact::Normal n = exact::normal(t);
    normal_ = {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    const double sum = std::abs(normal_[0]) + std::abs(normal_[1]) + std::abs(normal_[2]);
    reach_ = sum * (0.5 * side + 1e-9 * (side + 0x1p32));
  }

  [[nodiscard]] bool meets(const std::array<double, 3>& centre) const {
    double height = 0;
    for (std::size_t a = 0; a < 3; ++a) height += normal_[a] * (centre[a] - through_[a]);
    return std::abs(height) <= reach_;
  }

 private:
  std::array<double, 3> normal_, through_;
  double reach_;
};

}  // namespace

SurfaceBlocks::SurfaceBlocks(const Lattice& lattice)
    : origin_{std::int64_t{lattice.origin.x} * steps, std::int64_t{lattice.origin.y} * steps,
              std::int64_t{lattice.origin.z} * steps},
      side_(32 * std::int64_t{steps}) {
  const auto count = [&](std::size_t a) {
    return (2 * std::int64_t{lattice.cells[a]} * steps) / side_ + 1;
  };
  while (count(0) * count(1) * count(2) > most_blocks) side_ *= 2;
  count_ = {count(0), count(1), count(2)};
  marked_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
}

SurfaceBlocks::Range SurfaceBlocks::range(Coord3 low, Coord3 high) const {
  const std::array<std::int64_t, 3> lows{low.x, low.y, low.z}, highs{high.x, high.y, high.z};
  Range range;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto block = [&](std::int64_t at) {
      return std::clamp<std::int64_t>((at - origin_[a]) / side_, 0, count_[a] - 1);
    };
    range.low[a] = block(lows[a]);
    range.high[a] = block(highs[a]);
  }
  return range;
}

void SurfaceBlocks::add(const exact::Corners& t) {
  const auto [a, b, c] = t;
  const Range range = this->range(
      {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
      {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})});
  const Slab slab(t, static_cast<double>(side_));
  for (std::int64_t z = range.low[2]; z <= range.high[2]; ++z)
    for (std::int64_t y = range.low[1]; y <= range.high[1]; ++y)
      for (std::int64_t x = range.low[0]; x <= range.high[0]; ++x) {
        const auto middle = [&](std::size_t axis, std::int64_t i) {
          const std::int64_t half = side_ / 2;
          return static_cast<double>(origin_[axis] + i * side_ + half);
        };
        if (slab.meets({middle(0, x), middle(1, y), middle(2, z)})) marked_[block(x, y, z)] = true;
      }
}

bool SurfaceBlocks::any(const LatticeBox& box) const {
  const Range range = this->range(steps * box.low, steps * box.high);
  for (std::int64_t z = range.low[2]; z <= range.high[2]; ++z)
    for (std::int64_t y = range.low[1]; y <= range.high[1]; ++y)
      for (std::int64_t x = range.low[0]; x <= range.high[0]; ++x)
        if (marked_[block(x, y, z)]) return true;
  return false;
}

}  // namespace certet
