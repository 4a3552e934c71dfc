#pragma once
/// \file
/// Which stencil a structured tetrahedron has.

#include <cstddef>
#include <cstdint>

#include "lattice/cell_tables.hpp"
#include "row_window.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Of the tetrahedra of one row of cells after the other: where the diagonals follow the
/// cuts, those that the pattern of the signs says are compared.
class StencilChoice {
 public:
  StencilChoice(const WarpedLattice& warped, const RowWindow& rows)
      : warped_(warped), rows_(rows) {}

  /// The number of the stencil of case c of the cell at bit b of word w.
  [[nodiscard]] std::size_t operator()(std::size_t pattern, std::size_t c, int w, int b) const {
    const CutOrders& orders = orders_of_cuts[pattern];
    std::size_t order = 0;
    if (warped_.diagonals_follow_cuts)
      for (std::size_t n = 0; n < orders.pair_count; ++n) {
        const auto& [first, second] = orders.pairs[n];
        order |= std::size_t{cut(second, c, w, b) < cut(first, c, w, b)} << n;
      }
    return orders.stencil[order];
  }

 private:
  /// In steps from the + end.
  [[nodiscard]] std::int32_t cut(StencilVertex v, std::size_t c, int w, int b) const {
    const auto& [kind, owner, is_first] = cell.edge[c][v.a][v.b];
    const RowRanks& row = rows_.row(static_cast<std::size_t>(int{owner.y}),
                                    static_cast<std::size_t>(int{owner.z}));
    const WordBit at = WordBit{w, b}.moved(owner.x);
    return warped_.cuts[rows_.k() + owner.z].at(rows_.j() + owner.y, row,
                                                row.rank(kind, at.w, at.b));
  }

  const WarpedLattice& warped_;
  const RowWindow& rows_;
};

}  // namespace certet::core
