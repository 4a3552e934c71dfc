#include "certet/combined_solids.hpp"

#include <algorithm>

#include "certet/error.hpp"
#include "combined_domain.hpp"
#include "united.hpp"

namespace certet {
namespace {

/// `rule` makes a domain of two on one lattice.
template <class Rule>
Solid combined(const Solid& a, const Solid& b, const Bounds& bounds, const Rule& rule) {
  return {bounds,
          [a, b, rule, side = longest_side(bounds)](const PlacedLattice& around) {
            return rule(placed_on(a, around), placed_on(b, around), around, side);
          },
          a.own ? a.own : b.own, true};
}

Bounds common(const Bounds& one, const Bounds& other) {
  Bounds both = one;
  for (std::size_t a = 0; a < 3; ++a) {
    both.low[a] = std::max(both.low[a], other.low[a]);
    both.high[a] = std::min(both.high[a], other.high[a]);
    if (!(both.low[a] < both.high[a]))
      throw Error(ErrorCode::bad_option, "two solids have no place in common");
  }
  return both;
}

}  // namespace

Solid operator&(const Solid& a, const Solid& b) {
  return combined(a, b, common(a.bounds, b.bounds), both);
}

Solid operator|(const Solid& a, const Solid& b) {
  return combined(a, b, around(a.bounds, b.bounds), either);
}

Solid operator-(const Solid& a, const Solid& b) {
  return combined(a, b, a.bounds,
                  [](const DomainPart& whole, const DomainPart& hole, const PlacedLattice& around,
                     double side) { return both(whole, opposite(hole), around, side); });
}

}  // namespace certet
