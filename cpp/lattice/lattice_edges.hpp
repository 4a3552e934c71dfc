#pragma once
/// \file
/// How lattice vertices and lattice edges are named inside the engine.
///
/// A vertex is a grid (even or odd) and an index (i,j,k).  An edge belongs to
/// the index of one of its ends, its owner, and to one of 14 families: three
/// long ones on each grid, towards the next index of an axis, and eight short
/// ones from an odd vertex to the even corners of its cell.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/direction.hpp"
#include "certet/lattice/structured_tet.hpp"

namespace certet::core {

enum Grid : std::uint8_t { even = 0, odd = 1 };
inline constexpr int grid_count = 2;

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
/// within a row: corners of the two grids, then the cuts of the 14 families.
inline constexpr int corner_kinds = 2;
inline constexpr int family_count = 14;
inline constexpr int kind_count = corner_kinds + family_count;

/// The two ends of a family's edge, relative to its owner; the first one is
/// the owner itself.
struct Family {
  VertexRef first, second;
};

inline constexpr std::array<Family, family_count> families = [] {
  std::array<Family, family_count> table{};
  constexpr std::array<Shift, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table[axis] = {{even, {}}, {even, axes[axis]}};
    table[3 + axis] = {{odd, {}}, {odd, axes[axis]}};
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
    table[6 + corner] = {{odd, {}},
                         {even, {static_cast<std::int8_t>(corner & 1),
                                 static_cast<std::int8_t>(corner >> 1 & 1),
                                 static_cast<std::int8_t>(corner >> 2 & 1)}}};
  return table;
}();

/// An edge as one of its ends sees it.
struct EdgeRef {
  std::uint8_t kind;  ///< corner_kinds + family
  Shift owner;        ///< relative to the index of the end
  bool is_first;      ///< whether the end is the family's first
};

/// The vertex at a lattice offset (in lattice units) from the even point of an
/// index.
constexpr VertexRef vertex_at(Coord3 offset) {
  return {(offset.x & 1) != 0 ? odd : even,
          {static_cast<std::int8_t>(offset.x >> 1), static_cast<std::int8_t>(offset.y >> 1),
           static_cast<std::int8_t>(offset.z >> 1)}};
}

/// The neighbour of a vertex of `grid` in a direction, relative to its index.
constexpr VertexRef neighbor(Grid grid, std::size_t direction) {
  const std::int32_t g = grid == odd ? 1 : 0;
  return vertex_at(Coord3{g, g, g} + direction_offset[direction]);
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
inline constexpr std::array<std::array<EdgeRef, direction_count>, grid_count> edges_of = [] {
  std::array<std::array<EdgeRef, direction_count>, grid_count> table{};
  for (std::size_t d = 0; d < direction_count; ++d) {
    table[even][d] = edge_towards(even, d);
    table[odd][d] = edge_towards(odd, d);
  }
  return table;
}();

/// The direction of a family's edge as its first and its second end see it.
inline constexpr std::array<std::array<std::uint8_t, 2>, family_count> family_directions = [] {
  std::array<std::array<std::uint8_t, 2>, family_count> table{};
  for (const Grid grid : {even, odd})
    for (std::size_t d = 0; d < direction_count; ++d) {
      const EdgeRef& edge = edges_of[grid][d];
      table[edge.kind - corner_kinds][edge.is_first ? 0 : 1] = static_cast<std::uint8_t>(d);
    }
  return table;
}();

/// The vertices that are ends of the edges owned by an index, in the order in
/// which the families name them.
inline constexpr int edge_end_count = 12;

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
