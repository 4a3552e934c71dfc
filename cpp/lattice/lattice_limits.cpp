#include "certet/lattice/lattice_limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "certet/error.hpp"

namespace certet {

std::int32_t checked_cells(double cells) {
  if (!(cells <= cells_limit))
    throw Error(ErrorCode::too_large,
                "the lattice would have " +
                    std::to_string(static_cast<std::int64_t>(std::min(cells, 1e18))) +
                    " cells along one axis, more than " + std::to_string(cells_limit) +
                    "; choose a larger size");
  return static_cast<std::int32_t>(cells);
}

double checked_size(double size) {
  if (!std::isfinite(size) || size <= 0)
    throw Error(ErrorCode::bad_option, "the size must be a positive number");
  if (size < least_size || size > greatest_size)
    throw Error(ErrorCode::too_large,
                "the size, a long edge of the lattice, must be from 1e-30 to 1e30 world units");
  return size;
}

std::int32_t checked_margin(std::int32_t margin) {
  if (margin < 1) throw Error(ErrorCode::bad_option, "the margin must be at least 1");
  return margin;
}

}  // namespace certet
