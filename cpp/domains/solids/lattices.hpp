#pragma once
/// \file
/// Lattices of one frame.

#include <algorithm>
#include <array>
#include <optional>

#include "certet/lattice.hpp"

namespace certet {

/// From the cells of origins to the ends, along each axis.
struct CellRange {
  std::array<std::int32_t, 3> low, end;  ///< in cells from lattice point 0

  explicit CellRange(const Lattice& lattice)
      : low{lattice.origin.x / 2, lattice.origin.y / 2, lattice.origin.z / 2}, end(low) {
    for (std::size_t a = 0; a < 3; ++a) end[a] += lattice.cells[a];
  }
  [[nodiscard]] Lattice lattice() const {
    Lattice result{{2 * low[0], 2 * low[1], 2 * low[2]}, {}};
    for (std::size_t a = 0; a < 3; ++a) result.cells[a] = checked_cells(end[a] - low[a]);
    return result;
  }
};

/// The least one that holds both.  \throws Error `too_large` (coordinate range).
inline Lattice around(const Lattice& one, const Lattice& other) {
  CellRange both(one);
  const CellRange more(other);
  for (std::size_t a = 0; a < 3; ++a) {
    both.low[a] = std::min(both.low[a], more.low[a]);
    both.end[a] = std::max(both.end[a], more.end[a]);
  }
  return both.lattice();
}

/// What both have in common; nothing where that is empty.
inline std::optional<Lattice> common(const Lattice& one, const Lattice& other) {
  CellRange both(one);
  const CellRange more(other);
  for (std::size_t a = 0; a < 3; ++a) {
    both.low[a] = std::max(both.low[a], more.low[a]);
    both.end[a] = std::min(both.end[a], more.end[a]);
    if (both.low[a] >= both.end[a]) return std::nullopt;
  }
  return both.lattice();
}

}  // namespace certet
