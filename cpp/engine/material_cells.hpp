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

inline CellKinds kinds_of_cells(const SignPlanes& planes, const SignRows& signs, int j, int k,
                                int w) {
  CellKinds kinds{0, ~std::uint64_t{0}};
  for (const VertexRef& vertex : cell.vertices) {
    const SignWord word = signs.at(vertex, w);
    kinds.any |= word.plus | word.zero;
    kinds.whole &= word.plus;
  }
  if (kinds.whole != 0) kinds.whole &= planes.materials()->uniform_cells(j, k, w);
  return kinds;
}

inline Material material_of_whole_cell(const SignPlanes& planes, int i, int j, int k) {
  const auto& [grid, shift] = cell.vertices[0];
  return planes.materials()->at(grid, i + shift.x, j + shift.y, k + shift.z);
}

/// Calls visit(c, tet, material) for the tetrahedra of one cell, with their owners: case by
/// case, in the order of the stencil; those outside are left out.
template <class Visit>
void for_each_owned_tet(const SignPlanes& planes, int i, int j, int k, const Visit& visit) {
  std::array<Material, cell_vertex_count> material, lower;
  for (std::size_t v = 0; v < cell_vertex_count; ++v) {
    const auto& [grid, shift] = cell.vertices[v];
    const int x = i + shift.x;
    const int y = j + shift.y;
    const int z = k + shift.z;
    const auto bit = [x](const std::uint64_t* row) { return (row[x >> 6] >> (x & 63) & 1) != 0; };
    const bool moved = bit(planes.zero(grid, y, z));
    lower[v] = moved || bit(planes.plus(grid, y, z)) ? planes.materials()->at(grid, x, y, z) : 0;
    material[v] = moved ? moved_corner : lower[v];
  }
  for (std::size_t c = 0; c < cell_tet_count; ++c) {
    const auto& corner = cell.corner[c];
    const auto of_corners = [&](const auto& values) {
      return std::array{values[corner[0]], values[corner[1]], values[corner[2]], values[corner[3]]};
    };
    const CornerMaterials corners = of_corners(material);
    for (const MaterialTet& tet : material_tets(corners)) {
      // Corners that have all moved have one lower material, but for those that pieces were
      // dropped around: it is 0 of some then, and so is the tetrahedron's.
      const Material owner = tet.owner == shared_owner ? std::ranges::min(of_corners(lower))
                                                       : corners[tet.owner];
      if (owner != 0) visit(c, tet, owner);
    }
  }
}

/// The same without their owners.
template <class Visit>
void for_each_material_tet(const SignPlanes& planes, int i, int j, int k, const Visit& visit) {
  for_each_owned_tet(planes, i, j, k,
                     [&](std::size_t c, const MaterialTet& tet, Material material) {
                       visit(c, tet.vertices, material);
                     });
}

}  // namespace certet::core
