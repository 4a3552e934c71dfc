#pragma once
/// \file
/// Space with holes.

#include <algorithm>
#include <random>
#include <vector>

#include "certet/lattice.hpp"
#include "domains.hpp"

namespace domains {

/// All of a lattice but so many balls, somewhere in it, of radii from 0.2 to the greatest.
inline Positional with_holes(std::mt19937_64& random, const certet::Lattice& lattice, int holes,
                             double greatest) {
  std::vector<Level> all;
  for (int n = 0; n < holes; ++n) {
    const auto at = [&](std::int32_t from, std::int32_t cells) {
      return from + std::uniform_real_distribution(0.0, 2.0 * cells)(random);
    };
    const double x = at(lattice.origin.x, lattice.cells[0]);
    const double y = at(lattice.origin.y, lattice.cells[1]);
    const double z = at(lattice.origin.z, lattice.cells[2]);
    all.push_back(sphere(x, y, z, std::uniform_real_distribution(0.2, greatest)(random)));
  }
  return of_level([all](double x, double y, double z) {
    double level = -1;
    for (const Level& hole : all) level = std::max(level, -hole(x, y, z));
    return level;
  });
}

}  // namespace domains
