#pragma once
/// \file
/// Where the vertices of the tetrahedra of a row of an octree's cells are in the lattice.

#include <array>
#include <cstddef>
#include <cstdint>

#include "graded_rows.hpp"

namespace certet::core {

/// The vertices of a tetrahedron that cells of a row above level 0 name by one flag: they are
/// even, and lie in four rows of the lattice.
class GradedVertices {
 public:
  struct Row {
    int j, k;
    int x;  ///< of cell 0
  };

  GradedVertices(const Octree& octree, int level, const RowOfCells& cells, GradedKind kind,
                 std::size_t flag)
      : level_(level) {
    const auto& first = octree.grid(level).first;
    const auto& origin = octree.grid(0).first;
    const auto index = [&](std::size_t axis, int cell, int step) {
      return (2 * (first[axis] + cell) + 1 + step) * (1 << (level - 1)) - origin[axis];
    };
    const auto& steps = graded_tets[static_cast<std::size_t>(kind)][flag];
    for (std::size_t v = 0; v < 4; ++v)
      rows_[v] = {index(1, cells.j, steps[v].y), index(2, cells.k, steps[v].z),
                  index(0, 0, steps[v].x)};
  }

  [[nodiscard]] const std::array<Row, 4>& rows() const { return rows_; }
  /// The index along its row of a vertex of cell `cell`'s tetrahedron.
  [[nodiscard]] int index(std::size_t vertex, int cell) const {
    return rows_[vertex].x + (cell << level_);
  }

 private:
  int level_;
  std::array<Row, 4> rows_;
};

}  // namespace certet::core
