#pragma once
/// \file
/// The tetrahedra of cells in which materials meet each other, or the outside.

#include <algorithm>
#include <array>
#include <cstdint>

#include "certet/lattice/material_stencil.hpp"
#include "lattice/cell_tables.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// The cells that word w owns which have any tetrahedra, and those of them that are
/// whole: of one material, and none of their vertices moved.
struct CellKinds {
  std::uint64_t any, whole;
};

/// The cells of row (j,k).  Addresses are worked out once for all of them.
class MaterialCells {
 public:
  MaterialCells(const SignPlanes& planes, int j, int k)
      : materials_(*planes.materials()), signs_(planes, j, k), j_(j), k_(k) {
    for (std::size_t v = 0; v < cell_vertex_count; ++v) {
      const auto& [grid, shift] = cell.vertices[v];
      const int y = j + shift.y;
      const int z = k + shift.z;
      vertices_[v] = {planes.plus(grid, y, z), planes.zero(grid, y, z), materials_.row(grid, y, z)};
    }
  }

  [[nodiscard]] CellKinds kinds(int w) const {
    CellKinds kinds{0, ~std::uint64_t{0}};
    for (const VertexRef& vertex : cell.vertices) {
      const SignWord word = signs_.at(vertex, w);
      kinds.any |= word.plus | word.zero;
      kinds.whole &= word.plus;
    }
    if (kinds.whole != 0) kinds.whole &= materials_.uniform_cells(j_, k_, w);
    return kinds;
  }

  [[nodiscard]] Material material_of_whole(int i) const {
    return vertices_[0].materials.at(i + cell.vertices[0].shift.x);
  }

  /// Calls visit(c, tet, material) for the tetrahedra of cell i, with their owners: case by
  /// case, in the order of the stencil; those outside are left out.
  template <class Visit>
  void for_each_owned_tet(int i, const Visit& visit) const {
    const Cell materials(*this, i);
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      const CornerMaterials corners = materials.corners(c);
      for (const MaterialTet& tet : material_tets(corners)) {
        const Material owner =
            tet.owner == shared_owner ? materials.shared(c) : corners[tet.owner];
        if (owner != 0) visit(c, tet, owner);
      }
    }
  }

  /// How many these are.
  [[nodiscard]] std::uint64_t count_tets(int i) const {
    const Cell materials(*this, i);
    std::uint64_t count = 0;
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      const CornerMaterials corners = materials.corners(c);
      const auto& owned = owned_tets[pattern_of_likeness[likeness(corners)]];
      for (std::size_t n = 0; n < 4; ++n) count += corners[n] > 0 ? owned[n] : 0U;
      if (owned[shared_owner] != 0 && materials.shared(c) != 0) count += owned[shared_owner];
    }
    return count;
  }

  /// The same without their owners.
  template <class Visit>
  void for_each_tet(int i, const Visit& visit) const {
    for_each_owned_tet(i, [&](std::size_t c, const MaterialTet& tet, Material material) {
      visit(c, tet.vertices, material);
    });
  }

 private:
  /// How many tetrahedra of each pattern are of each corner, and shared.
  static constexpr std::array<std::array<std::uint8_t, 5>, material_pattern_count> owned_tets = [] {
    std::array<std::array<std::uint8_t, 5>, material_pattern_count> counts{};
    for (std::size_t p = 0; p < material_pattern_count; ++p)
      for (const MaterialTet& tet : material_stencil_table[p]) ++counts[p][tet.owner];
    return counts;
  }();

  /// The materials at the vertices of a cell.
  class Cell {
   public:
    Cell(const MaterialCells& cells, int i) {
      for (std::size_t v = 0; v < cell_vertex_count; ++v) {
        const auto& [plus, zero, materials] = cells.vertices_[v];
        const int x = i + cell.vertices[v].shift.x;
        const auto bit = [x](const std::uint64_t* row) {
          return (row[x >> 6] >> (x & 63) & 1) != 0;
        };
        const bool moved = bit(zero);
        lower_[v] = moved || bit(plus) ? materials.at(x) : 0;
        material_[v] = moved ? moved_corner : lower_[v];
      }
    }

    [[nodiscard]] CornerMaterials corners(std::size_t c) const { return of(material_, c); }
    /// Corners that have all moved have one lower material, but for those that pieces were
    /// dropped around: it is 0 of some then, and so is the tetrahedron's.
    [[nodiscard]] Material shared(std::size_t c) const { return std::ranges::min(of(lower_, c)); }

   private:
    using Materials = std::array<Material, cell_vertex_count>;

    static CornerMaterials of(const Materials& values, std::size_t c) {
      const auto& corner = cell.corner[c];
      return {values[corner[0]], values[corner[1]], values[corner[2]], values[corner[3]]};
    }

    Materials material_, lower_;
  };

  struct Vertex {
    const std::uint64_t *plus, *zero;  ///< of its row
    MaterialRow materials;
  };

  const MaterialPlanes& materials_;
  SignRows signs_;
  int j_, k_;
  std::array<Vertex, cell_vertex_count> vertices_;
};

}  // namespace certet::core
