#pragma once
/// \file
/// How lattice vertices and lattice edges are named inside the engine.
///
/// A vertex is a grid (of the lattice: even or odd) and an index (i,j,k), that of
/// its cell.  An edge belongs to the index of one of its ends, its owner, and to one
/// of the tiling's families: in the lattice three long ones on each grid, towards
/// the next index of an axis, and eight short ones from an odd vertex to the even
/// corners of its cell.  Picture: cpp/docs/pictures/ranks.svg.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/error.hpp"
#include "lattice/tiling_in_use.hpp"

namespace certet::core {

enum Grid : std::uint8_t { even = 0, odd = 1 };
inline constexpr int grid_count = static_cast<int>(tiling.grids.size());
inline constexpr std::array<Grid, grid_count> grids = [] {
  std::array<Grid, grid_count> list{};
  for (std::size_t g = 0; g < grid_count; ++g) list[g] = static_cast<Grid>(g);
  return list;
}();

/// Difference of indices.
struct Shift {
  std::int8_t x, y, z;
  friend constexpr bool operator==(const Shift&, const Shift&) = default;
};

/// A vertex relative to an index.
struct VertexRef {
  Grid grid;
  Shift shift;
  friend constexpr bool operator==(const VertexRef&, const VertexRef&) = default;
};

/// The kinds of points of the output, in the order in which they are numbered
/// within a row: corners of the grids, then the cuts of the families.
inline constexpr int corner_kinds = grid_count;
inline constexpr int family_count = static_cast<int>(tiling.edges.size());
inline constexpr int kind_count = corner_kinds + family_count;

/// The vertex at a lattice offset (in lattice units) from the reference point of an
/// index: of the grid from which it is an even number of units away.
constexpr VertexRef vertex_at(Coord3 offset) {
  for (const Grid grid : grids) {
    const Coord3 d = offset - tiling.grids[grid];
    if (((d.x | d.y | d.z) & 1) == 0)
      return {grid, {static_cast<std::int8_t>(d.x >> 1), static_cast<std::int8_t>(d.y >> 1),
                     static_cast<std::int8_t>(d.z >> 1)}};
  }
  throw Error(ErrorCode::bad_option, "no such vertex");  // never at run time
}

/// The two ends of a family's edge, relative to its owner; the first one is
/// the owner itself.
struct Family {
  VertexRef first, second;
};

inline constexpr std::array<Family, family_count> families = [] {
  std::array<Family, family_count> table{};
  for (std::size_t f = 0; f < family_count; ++f)
    table[f] = {vertex_at(tiling.edges[f].first), vertex_at(tiling.edges[f].second)};
  return table;
}();

/// An edge as one of its ends sees it.
struct EdgeRef {
  std::uint8_t kind;  ///< corner_kinds + family
  Shift owner;        ///< relative to the index of the end
  bool is_first;      ///< whether the end is the family's first
};

/// The neighbours of the vertices of each grid, by their directions.
inline constexpr auto neighbors_of = [] {
  std::array<std::array<VertexRef, tiling.directions.size()>, grid_count> table{};
  for (const Grid grid : grids)
    for (std::size_t d = 0; d < tiling.directions.size(); ++d)
      table[grid][d] = vertex_at(tiling.grids[grid] + tiling.directions[d]);
  return table;
}();

/// The neighbour of a vertex of `grid` in a direction, relative to its index.
constexpr const VertexRef& neighbor(Grid grid, std::size_t direction) {
  return neighbors_of[grid][direction];
}

constexpr EdgeRef edge_towards(Grid grid, std::size_t direction) {
  const VertexRef to = neighbor(grid, direction);
  for (std::size_t f = 0; f < family_count; ++f) {
    const Family& family = families[f];
    const Shift s = family.second.shift;
    const auto kind = static_cast<std::uint8_t>(corner_kinds + f);
    if (family.first.grid == grid && family.second.grid == to.grid &&
        s.x == to.shift.x && s.y == to.shift.y && s.z == to.shift.z)
      return {kind, {}, true};
    if (family.second.grid == grid && family.first.grid == to.grid &&
        s.x == -to.shift.x && s.y == -to.shift.y && s.z == -to.shift.z)
      return {kind, to.shift, false};
  }
  throw Error(ErrorCode::bad_option, "no such edge");  // never at run time
}

/// edges_of[grid][direction]
inline constexpr auto edges_of = [] {
  std::array<std::array<EdgeRef, tiling.directions.size()>, grid_count> table{};
  for (const Grid grid : grids)
    for (std::size_t d = 0; d < tiling.directions.size(); ++d)
      table[grid][d] = edge_towards(grid, d);
  return table;
}();

/// The direction of a family's edge as its first and its second end see it.
inline constexpr std::array<std::array<std::uint8_t, 2>, family_count> family_directions = [] {
  std::array<std::array<std::uint8_t, 2>, family_count> table{};
  for (const Grid grid : grids)
    for (std::size_t d = 0; d < tiling.directions.size(); ++d) {
      const EdgeRef& edge = edges_of[grid][d];
      table[edge.kind - corner_kinds][edge.is_first ? 0 : 1] = static_cast<std::uint8_t>(d);
    }
  return table;
}();

/// The vertices that are ends of the edges owned by an index, in the order in
/// which the families name them.
inline constexpr int edge_end_count = [] {
  int count = 0;
  for (std::size_t n = 0; n < 2 * family_count; ++n) {
    const auto end = [](std::size_t m) {
      return m % 2 == 0 ? families[m / 2].first : families[m / 2].second;
    };
    bool seen = false;
    for (std::size_t m = 0; m < n; ++m) seen = seen || end(m) == end(n);
    if (!seen) ++count;
  }
  return count;
}();

struct EdgeEnds {
  std::array<VertexRef, edge_end_count> vertices{};
  /// The two ends of each family, as numbers of `vertices`.
  std::array<std::array<std::uint8_t, 2>, family_count> of_family{};
};

inline constexpr EdgeEnds edge_ends = [] {
  EdgeEnds ends{};
  std::uint8_t count = 0;
  const auto number_of = [&](const VertexRef& v) {
    std::uint8_t n = 0;
    while (n < count && !(ends.vertices[n] == v)) ++n;
    if (n == count) ends.vertices[count++] = v;
    return n;
  };
  for (std::size_t f = 0; f < family_count; ++f) {
    const std::uint8_t first = number_of(families[f].first);
    ends.of_family[f] = {first, number_of(families[f].second)};
  }
  return ends;
}();

}  // namespace certet::core
