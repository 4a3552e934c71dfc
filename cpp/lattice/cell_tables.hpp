#pragma once
/// \file
/// The tetrahedra of one index, in the engine's names.

#include "lattice_edges.hpp"

namespace certet::core {

/// The tetrahedra of one index.
inline constexpr std::size_t cell_tet_count = tiling.tets.size();

/// Their distinct vertices.
inline constexpr int cell_vertex_count = [] {
  int count = 0;
  for (std::size_t n = 0; n < 4 * cell_tet_count; ++n) {
    bool seen = false;
    for (std::size_t m = 0; m < n; ++m)
      seen = seen || tiling.tets[m / 4].vertices[m % 4] == tiling.tets[n / 4].vertices[n % 4];
    if (!seen) ++count;
  }
  return count;
}();

struct CellTables {
  std::array<VertexRef, cell_vertex_count> vertices{};
  /// The cell vertex at each corner of each case.
  std::array<std::array<std::uint8_t, 4>, cell_tet_count> corner{};
  /// The edge between two corners of a case, relative to the cell.
  std::array<std::array<std::array<EdgeRef, 4>, 4>, cell_tet_count> edge{};
};

inline constexpr CellTables cell = [] {
  CellTables t{};
  std::array<Coord3, cell_vertex_count> seen{};
  std::uint8_t count = 0;
  for (std::size_t c = 0; c < cell_tet_count; ++c) {
    const auto& v = tiling.tets[c].vertices;
    for (std::size_t a = 0; a < 4; ++a) {
      std::uint8_t n = 0;
      while (n < count && !(seen[n] == v[a])) ++n;
      if (n == count) {
        seen[count] = v[a];
        t.vertices[count++] = vertex_at(v[a]);
      }
      t.corner[c][a] = n;
      for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t d = 0; d < tiling.directions.size(); ++d)
          if (v[a] + tiling.directions[d] == v[b]) {
            const VertexRef from = vertex_at(v[a]);
            EdgeRef e = edges_of[from.grid][d];
            e.owner = {static_cast<std::int8_t>(e.owner.x + from.shift.x),
                       static_cast<std::int8_t>(e.owner.y + from.shift.y),
                       static_cast<std::int8_t>(e.owner.z + from.shift.z)};
            t.edge[c][a][b] = e;
          }
    }
  }
  return t;
}();

/// The order in which the vertices of a case's tetrahedra are written, for a
/// positive volume: `Orient` of the certificate.
inline constexpr std::array<VertexOrder, cell_tet_count> output_orders = [] {
  std::array<VertexOrder, cell_tet_count> orders{};
  for (std::size_t c = 0; c < cell_tet_count; ++c)
    orders[c] = tiling.tets[c].right_handed ? VertexOrder{0, 1, 2, 3}
                                                     : VertexOrder{0, 1, 3, 2};
  return orders;
}();

/// The vertices of the tetrahedra of an interior cell, as numbers of
/// `cell.vertices`, in the order of the output.
inline constexpr int interior_size = 4 * int{cell_tet_count};
inline constexpr std::array<std::uint8_t, interior_size> interior_vertices = [] {
  std::array<std::uint8_t, interior_size> list{};
  for (std::size_t c = 0; c < cell_tet_count; ++c)
    for (std::size_t n = 0; n < 4; ++n) list[4 * c + n] = cell.corner[c][output_orders[c][n]];
  return list;
}();

}  // namespace certet::core
