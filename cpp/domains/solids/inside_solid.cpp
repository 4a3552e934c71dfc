#include <algorithm>
#include <array>
#include <cmath>

#include "certet/lattice/structured_tet.hpp"
#include "certet/solid.hpp"

namespace certet {
namespace {

constexpr std::size_t points_at_once = 4096;

/// In steps; beyond the lattice all coordinates are a corner of it, which is outside.
Coord3 nearest_position(const Point3& point, const PlacedLattice& around) {
  const std::int32_t corner = around.lattice.origin.x * steps;
  std::array<std::int32_t, 3> at{};
  const std::array<std::int32_t, 3> lows{around.lattice.origin.x, around.lattice.origin.y,
                                         around.lattice.origin.z};
  for (std::size_t a = 0; a < 3; ++a) {
    const double place =
        (point[a] - around.frame.origin[a]) * (2 * steps / around.frame.size);
    const double low = double{steps} * lows[a];
    if (!(place >= low && place <= low + 2.0 * steps * around.lattice.cells[a]))
      return {corner, lows[1] * steps, lows[2] * steps};
    at[a] = static_cast<std::int32_t>(std::lround(place));
  }
  return {at[0], at[1], at[2]};
}

}  // namespace

std::vector<std::uint8_t> inside(const Solid& solid, std::span<const Point3> points) {
  const PlacedLattice around =
      lattice_around(solid.bounds, longest_side(solid.bounds) / 512, 1);
  const std::shared_ptr<const PlacedDomain> domain = placed_on(solid, around);
  std::vector<std::uint8_t> result(points.size());
  std::vector<Coord3> positions;
  std::vector<Sign> signs;
  for (std::size_t begin = 0; begin < points.size(); begin += points_at_once) {
    const auto some = points.subspan(begin, std::min(points_at_once, points.size() - begin));
    positions.clear();
    for (const Point3& point : some) positions.push_back(nearest_position(point, around));
    signs.resize(some.size());
    domain->at(positions, signs);
    for (std::size_t i = 0; i < some.size(); ++i)
      result[begin + i] = signs[i] == Sign::minus ? 0 : 1;
  }
  return result;
}

}  // namespace certet
