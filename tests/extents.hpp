#pragma once
/// \file
/// Whether what a domain says of blocks is what it says of their points.

#include <array>
#include <random>
#include <string>

#include "certet/domain.hpp"
#include "certet/stuffing.hpp"
#include "seed.hpp"

namespace extents {

/// Looks at a block of the lattice by chance; where its signs contradict its
/// extent, says so.  Counts the blocks that were decided.
template <class Random>
std::string contradiction(Random& random, const certet::Domain& domain,
                          const certet::Lattice& lattice, int& decided) {
  using certet::Coord3;
  using certet::Extent;
  using certet::Sign;
  constexpr int side = 6, last = 2 * side - 1;
  const auto at = [&](std::int32_t from, std::int32_t count) {
    return from + 2 * between(random, 0, count - side);
  };
  const Coord3 low{at(lattice.origin.x, lattice.cells[0]), at(lattice.origin.y, lattice.cells[1]),
                   at(lattice.origin.z, lattice.cells[2])};
  const Extent extent = domain.extent({low, low + Coord3{last, last, last}});
  if (extent == Extent::mixed) return "";
  ++decided;
  const Sign expected = extent == Extent::inside ? Sign::plus : Sign::minus;
  std::array<Sign, side> signs;
  for (int z = 0; z <= last; ++z)
    for (int y = 0; y <= last; ++y)
      for (int x = 0; x < 2; ++x) {
        domain.row(low + Coord3{x, y, z}, signs);
        for (const Sign sign : signs)
          if (sign != expected)
            return "the block at " + std::to_string(low.x) + " " + std::to_string(low.y) + " " +
                   std::to_string(low.z) + " has points on both sides";
      }
  return "";
}

/// The first contradiction of many blocks; empty if there is none.
template <class Random>
std::string first_contradiction(Random& random, const certet::Domain& domain,
                                const certet::Lattice& lattice, int blocks, int& decided) {
  for (int i = 0; i < blocks; ++i)
    if (std::string found = contradiction(random, domain, lattice, decided); !found.empty())
      return found;
  return "";
}

}  // namespace extents
