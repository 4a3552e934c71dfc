#include "volume_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace soak {
namespace {

using certet::Coord3;
using certet::Sign;

/// Anywhere in the lattice's box.
Coord3 random_position(const certet::Lattice& lattice, std::mt19937_64& random) {
  const auto along = [&](std::int32_t from, std::int32_t cells) {
    const std::int32_t length = 2 * cells * certet::steps;
    return certet::steps * from +
           static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(length));
  };
  const auto& [origin, cells] = lattice;
  return {along(origin.x, cells[0]), along(origin.y, cells[1]), along(origin.z, cells[2])};
}

}  // namespace

Star star(Coord3 position, std::int32_t reach) {
  Star around{position};
  for (std::size_t i = 0; i < certet::direction_offset.size(); ++i)
    around[i + 1] = position + reach * certet::direction_offset[i];
  return around;
}

VolumeEstimate estimate_volume(const Trial& trial) {
  constexpr int count = 24'000;
  std::mt19937_64 random(trial.seed);
  int inside = 0, near = 0, deep = 0;
  for (int i = 0; i < count; ++i) {
    std::array<Sign, std::tuple_size_v<Star>> signs;
    trial.domain->at(star(random_position(trial.lattice, random), certet::steps / 2), signs);
    const bool is_near = std::ranges::any_of(signs, [&](Sign s) { return s != signs[0]; });
    inside += signs[0] == Sign::plus;
    near += is_near;
    deep += !is_near && signs[0] == Sign::plus;
  }
  double one = 1.0 / count;
  for (const std::int32_t n : trial.lattice.cells) one *= 2 * n;
  const double share = double(inside) / count;
  return {one * inside, one * deep, one * near, one * std::sqrt(count * share * (1 - share))};
}

}  // namespace soak
