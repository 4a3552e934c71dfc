#pragma once
/// \file
/// Vertices of the lattice and points of the mesh, by their places in it.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "lattice/lattice_edges.hpp"

namespace certet::core {

/// A vertex of the lattice.
struct VertexIndex {
  Grid grid;
  std::int32_t i, j, k;

  /// Its neighbour in a direction.
  [[nodiscard]] VertexIndex next(std::size_t direction) const {
    return at(neighbor(grid, direction));
  }
  /// The vertex at `ref` from its index.
  [[nodiscard]] VertexIndex at(const VertexRef& ref) const {
    return {ref.grid, i + ref.shift.x, j + ref.shift.y, k + ref.shift.z};
  }
  friend bool operator==(const VertexIndex&, const VertexIndex&) = default;
};

/// A point of the mesh: which kind, and the index that owns it.
struct PointIndex {
  std::uint8_t kind;  ///< a grid's corner, or corner_kinds + family
  std::int32_t i, j, k;

  static PointIndex corner(const VertexIndex& v) { return {v.grid, v.i, v.j, v.k}; }
  /// The cut of the edge from a vertex in a direction.
  static PointIndex cut(const VertexIndex& v, std::size_t direction) {
    const EdgeRef& edge = edges_of[v.grid][direction];
    return {edge.kind, v.i + edge.owner.x, v.j + edge.owner.y, v.k + edge.owner.z};
  }

  [[nodiscard]] bool is_corner() const { return kind < corner_kinds; }
  [[nodiscard]] VertexIndex vertex() const { return {static_cast<Grid>(kind), i, j, k}; }
  [[nodiscard]] std::size_t family() const { return kind - std::size_t{corner_kinds}; }

  friend bool operator==(const PointIndex&, const PointIndex&) = default;
  /// As the points are numbered.
  friend auto operator<=>(const PointIndex& a, const PointIndex& b) {
    return std::tie(a.k, a.j, a.kind, a.i) <=> std::tie(b.k, b.j, b.kind, b.i);
  }
};

}  // namespace certet::core
