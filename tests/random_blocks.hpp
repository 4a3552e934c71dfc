#pragma once
/// \file
/// Small blocks of a lattice, by chance.

#include <string>

#include "certet/lattice.hpp"
#include "seed.hpp"

/// The first point of a block of so many points a side within the lattice.
template <class Random>
certet::Coord3 random_block(Random& random, const certet::Lattice& lattice, std::int32_t side) {
  const auto at = [&](std::int32_t from, std::int32_t count) {
    return from + 2 * between(random, 0, count - side);
  };
  return {at(lattice.origin.x, lattice.cells[0]), at(lattice.origin.y, lattice.cells[1]),
          at(lattice.origin.z, lattice.cells[2])};
}

/// The first fault that look() tells in so many times; empty if there is none.
template <class Look>
std::string first_fault(int times, const Look& look) {
  for (int i = 0; i < times; ++i)
    if (std::string found = look(); !found.empty()) return found;
  return "";
}
