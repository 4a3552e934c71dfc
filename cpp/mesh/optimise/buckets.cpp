#include "buckets.hpp"

#include <algorithm>
#include <utility>

namespace certet::optimising {
namespace {

/// In lattice units; those that move at once must be more than eight apart, twice the greatest
/// width of a tetrahedron.
constexpr int width_bits = 4;

/// Its colour, and then which cube it is.
std::uint64_t key_of(Coord3 place) {
  std::uint64_t colour = 0, cube = 0;
  for (const std::int32_t c : {place.z, place.y, place.x}) {
    const auto index = static_cast<std::uint64_t>((std::int64_t{c} >> (step_bits + width_bits)) +
                                                  (coordinate_limit >> width_bits) + 1);
    colour = 2 * colour + index % 2;
    cube = (cube << 16) + index;
  }
  return (colour << 48) + cube;
}

}  // namespace

Buckets buckets_of(std::span<const Coord3> places) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(places.size());
  for (std::uint32_t v = 0; v < places.size(); ++v) keys.emplace_back(key_of(places[v]), v);
  std::ranges::sort(keys);
  Buckets buckets{{}, std::vector<std::vector<Bucket>>(8)};
  buckets.order.reserve(keys.size());
  for (std::uint32_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    const std::uint64_t key = keys[begin].first;
    for (; end < keys.size() && keys[end].first == key; ++end)
      buckets.order.push_back(keys[end].second);
    buckets.colours[key >> 48].push_back({begin, end});
  }
  return buckets;
}

}  // namespace certet::optimising
