#pragma once
/// \file
/// The signs of the vertices of 64 cells.

#include <array>
#include <cstddef>
#include <cstdint>

#include "lattice/cell_tables.hpp"
#include "sign_planes.hpp"
#include "stencil_counts.hpp"

namespace certet::core {

/// Of word w of a row.
struct CellWord {
  std::array<SignWord, cell_vertex_count> vertex;
  std::uint64_t any_plus = 0;                 ///< cells with a vertex inside
  std::uint64_t all_plus = ~std::uint64_t{0};  ///< those with no other

  CellWord(const SignRows& rows, int w) {
    for (std::size_t v = 0; v < cell_vertex_count; ++v) {
      vertex[v] = rows.at(cell.vertices[v], w);
      any_plus |= vertex[v].plus;
      all_plus &= vertex[v].plus;
    }
  }

  /// Of the cell at bit b.
  [[nodiscard]] std::array<Sign, cell_vertex_count> signs(int b) const {
    std::array<Sign, cell_vertex_count> sign;
    for (std::size_t v = 0; v < cell_vertex_count; ++v)
      sign[v] = sign_of_bits(static_cast<int>(vertex[v].plus >> b & 1),
                             static_cast<int>(vertex[v].zero >> b & 1));
    return sign;
  }

  /// How many tetrahedra the stencils at a case have.
  [[nodiscard]] StencilCounts counts(const std::array<std::uint8_t, 4>& corner) const {
    return stencil_counts(
        {vertex[corner[0]], vertex[corner[1]], vertex[corner[2]], vertex[corner[3]]});
  }
};

}  // namespace certet::core
