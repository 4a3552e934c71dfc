#include <algorithm>
#include <cmath>

#include "certet/error.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/moved_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

std::shared_ptr<const PlacedDomain> placed_on(const Solid& solid, const PlacedLattice& around) {
  const Frame& frame = around.frame;
  if (solid.any_axes || frame.axes == Frame{}.axes) return solid.on(around);
  const Frame upright{frame.origin, Frame{}.axes, frame.size};
  return moved_domain(solid.on({lattice_holding(upright, solid.bounds, 1), upright}), around);
}

Lattice lattice_holding(const Frame& frame, const Bounds& bounds, std::int32_t margin) {
  Point3 low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  for (int corner = 0; corner < 8; ++corner) {
    const Point3 at = frame.position({corner & 1 ? bounds.high[0] : bounds.low[0],
                                      corner & 2 ? bounds.high[1] : bounds.low[1],
                                      corner & 4 ? bounds.high[2] : bounds.low[2]});
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], at[a]);
      high[a] = std::max(high[a], at[a]);
    }
  }
  std::array<std::int32_t, 3> origin{};
  Lattice lattice;
  for (std::size_t a = 0; a < 3; ++a) {
    const double first = std::floor(low[a] / 2) - margin, end = std::ceil(high[a] / 2) + margin;
    if (!(std::fabs(first) < anchor_limit / 2 && std::fabs(end) < anchor_limit / 2))
      throw Error(ErrorCode::too_large,
                  "a solid lies too far from the others for a lattice of this size");
    origin[a] = 2 * static_cast<std::int32_t>(first);
    lattice.cells[a] = checked_cells(end - first + 1);
  }
  lattice.origin = {origin[0], origin[1], origin[2]};
  return lattice;
}

PlacedLattice own_lattice(const Solid& solid, double size, std::int32_t margin) {
  return solid.own ? solid.own(size, margin) : lattice_around(solid.bounds, size, margin);
}

std::shared_ptr<const PlacedDomain> solid_domain(const Solid& solid, double size,
                                                 std::int32_t margin) {
  return placed_on(solid, own_lattice(solid, size, margin));
}

}  // namespace certet
