#pragma once
/// \file
/// Whether what a domain says of blocks is what it says of their points.

#include <array>
#include <random>
#include <string>

#include "certet/domain.hpp"
#include "certet/stuffing.hpp"
#include "random_blocks.hpp"
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
  const Coord3 low = random_block(random, lattice, side);
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
  return first_fault(blocks, [&] { return contradiction(random, domain, lattice, decided); });
}

/// How many blocks of 16 cells a side are known to be on one side, and where one has a point
/// on the other; looked at in four rows of each.
struct Known {
  int inside = 0, outside = 0;
  std::string contradiction;
};

inline Known known_blocks(const certet::Domain& domain, const certet::Lattice& lattice) {
  using certet::Coord3;
  using certet::Extent;
  using certet::Sign;
  Known known;
  std::array<Sign, 16> row;
  for (int k = 0; k < lattice.cells[2]; k += 16)
    for (int j = 0; j < lattice.cells[1]; j += 16)
      for (int i = 0; i < lattice.cells[0]; i += 16) {
        const Coord3 low = lattice.origin + 2 * Coord3{i, j, k};
        const Extent extent = domain.extent({low, low + Coord3{31, 31, 31}});
        if (extent == Extent::mixed) continue;
        ++(extent == Extent::inside ? known.inside : known.outside);
        for (int n = 0; n < 16; n += 5) {
          domain.row(low + Coord3{0, 2 * n, 2 * ((7 * n) % 16)}, row);
          for (const Sign sign : row)
            if (sign != (extent == Extent::inside ? Sign::plus : Sign::minus))
              known.contradiction = "the block at " + std::to_string(i) + " " +
                                    std::to_string(j) + " " + std::to_string(k) +
                                    " has points on both sides";
        }
      }
  return known;
}

}  // namespace extents
