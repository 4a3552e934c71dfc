#include "budget.hpp"

#include <algorithm>

namespace certet::core {

bool SearchBudget::pay_for(const PlacedDomain& domain) {
  constexpr std::int32_t side = 32;  // lattice units
  const auto& count = domain.lattice().cells;
  cells -= 1.0 * count[0] * count[1] * count[2];
  if (cells < 0) return false;
  const Coord3 low = domain.lattice().origin;
  for (std::int32_t z = 0; z < 2 * count[2]; z += side)
    for (std::int32_t y = 0; y < 2 * count[1]; y += side)
      for (std::int32_t x = 0; x < 2 * count[0] && mixed >= 0; x += side) {
        const Coord3 high{std::min(x + side, 2 * count[0]), std::min(y + side, 2 * count[1]),
                          std::min(z + side, 2 * count[2])};
        if (domain.extent({low + Coord3{x, y, z}, low + high}) == Extent::mixed)
          mixed -= 0.125 * (high.x - x) * (high.y - y) * (high.z - z);
      }
  return mixed >= 0;
}

}  // namespace certet::core
