#pragma once
/// \file
/// Where the vertices of the tetrahedra of a row of an octree's cells are in the lattice.

#include <array>
#include <cstddef>
#include <cstdint>

#include "graded_rows.hpp"
#include "lattice/lattice_edges.hpp"

namespace certet::core {

/// A vertex of a tetrahedron that cells above level 0 name by a flag, as seen from the cell: in
/// which of the rows of even points that are at most two half sides away, and where along it.
struct CoarseVertex {
  std::uint8_t row;  ///< 5 (z + 2) + y + 2, in half sides
  std::uint8_t x;    ///< x + 2
};

inline constexpr std::size_t coarse_row_count = 25;

/// By kind and flag.
inline constexpr auto coarse_tets = [] {
  std::array<std::array<std::array<CoarseVertex, 4>, flag_count>, graded_kinds.size()> table{};
  for (std::size_t kind = 0; kind < table.size(); ++kind)
    for (std::size_t n = 0; n < flag_count; ++n)
      for (std::size_t v = 0; v < 4; ++v) {
        const Coord3 step = graded_tets[kind][n][v];
        table[kind][n][v] = {static_cast<std::uint8_t>(5 * (step.z + 2) + step.y + 2),
                             static_cast<std::uint8_t>(step.x + 2)};
      }
  return table;
}();

/// The vertices of the pyramids that cells of level 0 name by a flag; none of a tiling without
/// cells.
inline constexpr auto pyramids_at_cells = [] {
  std::array<std::array<VertexRef, 4>, flag_count> table{};
  if (grid_count != 2) return table;
  for (std::size_t n = 0; n < flag_count; ++n)
    for (std::size_t v = 0; v < 4; ++v)
      table[n][v] = vertex_at(
          Coord3{1, 1, 1} + graded_tets[static_cast<std::size_t>(GradedKind::pyramid)][n][v]);
  return table;
}();

/// Where these rows are, for a row of cells above level 0, and these places along them.
class GradedVertices {
 public:
  struct Row {
    int j, k;
  };

  GradedVertices(const Octree& octree, int level, const RowOfCells& cells) : level_(level) {
    const auto& first = octree.grid(level).first;
    const auto& origin = octree.grid(0).first;
    for (std::int32_t step = -2; step <= 2; ++step) {
      const auto index = [&](std::size_t axis, int cell) {
        return (2 * (first[axis] + cell) + 1 + step) * (1 << (level - 1)) - origin[axis];
      };
      const auto at = static_cast<std::size_t>(step + 2);
      x_[at] = index(0, 0);
      y_[at] = index(1, cells.j);
      z_[at] = index(2, cells.k);
    }
  }

  [[nodiscard]] Row row(std::size_t number) const { return {y_[number % 5], z_[number / 5]}; }
  /// The index along its row of a vertex of cell `cell`'s tetrahedron.
  [[nodiscard]] int index(CoarseVertex vertex, int cell) const {
    return x_[vertex.x] + (cell << level_);
  }

 private:
  int level_;
  std::array<int, 5> x_{}, y_{}, z_{};
};

}  // namespace certet::core
