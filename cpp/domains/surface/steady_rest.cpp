#include "steady_rest.hpp"

#include <cmath>
#include <limits>

#include "certet/lattice/structured_tet.hpp"

namespace certet {
namespace {

constexpr std::int32_t not_asked = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t not_steady = not_asked - 1;

/// A block has at least four cells of the lattice along each axis.
constexpr std::int64_t least_steady_side = 8 * std::int64_t{steps};
constexpr std::int64_t most_steady_blocks = std::int64_t{1} << 22;

}  // namespace

SteadyRest::SteadyRest(const Rims& rims, const IntegerBox& box)
    : rims_(rims), low_{box.low.x, box.low.y, box.low.z}, side_(least_steady_side) {
  const std::int64_t high[3] = {box.high.x, box.high.y, box.high.z};
  const auto divide = [&] {
    std::int64_t all = 1;
    for (std::size_t a = 0; a < 3; ++a) all *= count_[a] = (high[a] - low_[a]) / side_ + 1;
    return all;
  };
  while (divide() > most_steady_blocks) side_ *= 2;
  const auto all = static_cast<std::size_t>(divide());
  blocks_ = std::make_unique<Entry[]>(all);
  for (std::size_t n = 0; n < all; ++n) blocks_[n].store(not_asked, std::memory_order_relaxed);
}

std::optional<int> SteadyRest::whole(Coord3 p) const {
  const std::int64_t at[3] = {p.x, p.y, p.z};
  std::int64_t block[3];
  std::int64_t number = 0;
  for (std::size_t a = 3; a-- > 0;) {
    block[a] = (at[a] - low_[a]) / side_;
    if (at[a] < low_[a] || block[a] >= count_[a]) return std::nullopt;
    number = number * count_[a] + block[a];
  }
  // Threads that find it at once find the same.
  Entry& entry = blocks_[static_cast<std::size_t>(number)];
  std::int32_t found = entry.load(std::memory_order_relaxed);
  if (found == not_asked) entry.store(found = find(block), std::memory_order_relaxed);
  if (found == not_steady) return std::nullopt;
  return found;
}

std::int32_t SteadyRest::find(const std::int64_t (&block)[3]) const {
  const auto corner = [&](std::int64_t more) {
    std::int32_t at[3];
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = static_cast<std::int32_t>(low_[a] + block[a] * side_ + more);
    return Coord3{at[0], at[1], at[2]};
  };
  // Moved positions are a little beyond.
  if (rims_.may_be_ahead({corner(-1), corner(side_)})) return not_steady;
  const Coord3 middle = corner(side_ / 2);
  const double rest = rims_.rest(middle, exact::Nudge::forward), near = std::round(rest);
  const double room = 0.5 - std::fabs(rest - near) - lost_far_away;
  const double radius = std::sqrt(3.0) / 2 * static_cast<double>(side_) + 2;
  if (!(room > 0) || !(rims_.variation(middle, radius, room) <= room)) return not_steady;
  return static_cast<std::int32_t>(near);
}

std::uint64_t SteadyRest::bytes() const {
  return static_cast<std::uint64_t>(count_[0] * count_[1] * count_[2]) * sizeof(Entry);
}

}  // namespace certet
