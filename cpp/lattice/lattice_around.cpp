#include <algorithm>
#include <cmath>

#include "certet/error.hpp"
#include "certet/lattice.hpp"
#include "certet/lattice/lattice_limits.hpp"

namespace certet {
namespace {

void validate(const Bounds& bounds) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double side = bounds.high[a] - bounds.low[a];
    if (!std::isfinite(side) || side <= 0)
      throw Error(ErrorCode::bad_option,
                  "the bounds must be finite, and each low one less than the high one");
  }
}

/// Even cells, so that the even point (0,0,0) is in the middle.
std::int32_t cells_along(double side, double size, std::int32_t margin) {
  return checked_cells(2 * (std::ceil(side / (2 * size)) + margin));
}

}  // namespace

double longest_side(const Bounds& bounds) {
  return std::max({bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1],
                   bounds.high[2] - bounds.low[2]});
}

PlacedLattice lattice_around(const Bounds& bounds, double size, std::int32_t margin) {
  validate(bounds);
  checked_margin(margin);
  PlacedLattice result;
  result.frame.size = checked_size(size == 0 ? longest_side(bounds) / 64 : size);
  auto& cells = result.lattice.cells;
  for (std::size_t a = 0; a < 3; ++a) {
    result.frame.origin[a] = 0.5 * (bounds.low[a] + bounds.high[a]);
    cells[a] = cells_along(bounds.high[a] - bounds.low[a], result.frame.size, margin);
  }
  result.lattice.origin = {-cells[0], -cells[1], -cells[2]};
  return result;
}

}  // namespace certet
