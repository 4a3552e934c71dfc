#pragma once
/// \file
/// The rows of a lattice, one by one, and what a domain says of their points.

#include <cstddef>
#include <vector>

#include "certet/domain.hpp"
#include "certet/lattice.hpp"

/// Calls visit(first) with the first point of every row along x, in lattice units.
template <class Visit>
void for_each_row(const certet::Lattice& lattice, const Visit& visit) {
  for (int k = 0; k < 2 * lattice.cells[2]; ++k)
    for (int j = k % 2; j < 2 * lattice.cells[1]; j += 2)
      visit(lattice.origin + certet::Coord3{k % 2, j, k});
}

/// Calls visit(position, in_row, alone) for every point, its position in steps: what the
/// domain says of it in its row and by itself.
template <class Visit>
void for_each_sign(const certet::Domain& domain, const certet::Lattice& lattice,
                   const Visit& visit) {
  std::vector<certet::Sign> row(static_cast<std::size_t>(lattice.cells[0]));
  for_each_row(lattice, [&](certet::Coord3 first) {
    domain.row(first, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const certet::Coord3 position =
          certet::steps * (first + certet::Coord3{2 * static_cast<int>(i), 0, 0});
      certet::Sign alone;
      domain.at({&position, 1}, {&alone, 1});
      visit(position, row[i], alone);
    }
  });
}
