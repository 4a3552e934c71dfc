#pragma once
/// \file
/// The structured tetrahedra of the lattice (section 3.1 of the paper).
/// Picture: cpp/docs/pictures/lattice.svg.

#include <array>
#include <cstdint>
#include <string_view>

#include "certet/lattice/coord3.hpp"
#include "certet/error.hpp"

namespace certet {

/// The twelve orientations: I, J, K name the axis of the even edge, the digit
/// one of the four tetrahedra around it.
enum class StructuredTetCase : std::uint8_t {
  I1, I2, I3, I4, J1, J2, J3, J4, K1, K2, K3, K4
};
inline constexpr int case_count = 12;
inline constexpr std::array<std::string_view, case_count> case_names{
    "I1", "I2", "I3", "I4", "J1", "J2", "J3", "J4", "K1", "K2", "K3", "K4"};

/// The reference point of the lattice cube (lattice units), and a case.
struct StructuredTetId {
  Coord3 anchor;
  StructuredTetCase orientation;
  friend constexpr bool operator==(const StructuredTetId&, const StructuredTetId&) = default;
};

/// A permutation of four vertices: result[n] = argument[order[n]].
using VertexOrder = std::array<std::uint8_t, 4>;
inline constexpr VertexOrder order_1234{0, 1, 2, 3};
inline constexpr VertexOrder order_2143{1, 0, 3, 2};

template <class T>
constexpr std::array<T, 4> apply(const VertexOrder& order, const std::array<T, 4>& v) {
  return {v[order[0]], v[order[1]], v[order[2]], v[order[3]]};
}

/// A face neighbour, and the order that lines its vertices up with one's own:
/// after `order` they agree everywhere but at the vertex across from the face.
struct FaceNeighbor {
  StructuredTetId id;
  VertexOrder order;
};

/// v1 v2 is a long edge between even points, v3 v4 one between odd points; the
/// other four edges are short.  neighbors[i] is across from vertices[i].
struct StructuredTet {
  std::array<Coord3, 4> vertices;
  std::array<FaceNeighbor, 4> neighbors;
};

/// One row of the lattice table: everything relative to the reference point.
struct StructuredTetShape {
  std::array<Coord3, 4> vertices;
  std::array<FaceNeighbor, 4> neighbors;
  bool right_handed;  ///< det(v2-v1, v3-v1, v4-v1) = +4, otherwise -4
};

/// The lattice table, indexed by StructuredTetCase.
inline constexpr std::array<StructuredTetShape, case_count> structured_tet_table = [] {
  using enum StructuredTetCase;
  using Row = StructuredTetShape;
  constexpr VertexOrder same = order_1234;
  constexpr VertexOrder flip = order_2143;
  return std::array<Row, case_count>{{
      Row{{{{0, 2, 2}, {2, 2, 2}, {1, 3, 1}, {1, 3, 3}}},
          {{{{{0, 2, 0}, J4}, flip}, {{{-2, 2, 0}, J1}, same},
            {{{0, 0, 0}, I3}, same}, {{{0, 0, 0}, I2}, same}}},
          true},
      Row{{{{0, 2, 2}, {2, 2, 2}, {1, 3, 1}, {1, 1, 1}}},
          {{{{{0, 0, 0}, K4}, same}, {{{-2, 0, 0}, K1}, flip},
            {{{0, 0, 0}, I4}, same}, {{{0, 0, 0}, I1}, same}}},
          false},
      Row{{{{0, 2, 2}, {2, 2, 2}, {1, 1, 3}, {1, 3, 3}}},
          {{{{{0, 0, 2}, K4}, flip}, {{{-2, 0, 2}, K1}, same},
            {{{0, 0, 0}, I1}, same}, {{{0, 0, 0}, I4}, same}}},
          false},
      Row{{{{0, 2, 2}, {2, 2, 2}, {1, 1, 3}, {1, 1, 1}}},
          {{{{{0, 0, 0}, J4}, same}, {{{-2, 0, 0}, J1}, flip},
            {{{0, 0, 0}, I2}, same}, {{{0, 0, 0}, I3}, same}}},
          true},
      Row{{{{2, 0, 2}, {2, 2, 2}, {3, 1, 1}, {3, 1, 3}}},
          {{{{{2, 0, 0}, I4}, flip}, {{{2, -2, 0}, I1}, same},
            {{{0, 0, 0}, J3}, same}, {{{0, 0, 0}, J2}, same}}},
          false},
      Row{{{{2, 0, 2}, {2, 2, 2}, {3, 1, 1}, {1, 1, 1}}},
          {{{{{0, 0, 0}, K2}, same}, {{{0, -2, 0}, K3}, flip},
            {{{0, 0, 0}, J4}, same}, {{{0, 0, 0}, J1}, same}}},
          true},
      Row{{{{2, 0, 2}, {2, 2, 2}, {1, 1, 3}, {3, 1, 3}}},
          {{{{{0, 0, 2}, K2}, flip}, {{{0, -2, 2}, K3}, same},
            {{{0, 0, 0}, J1}, same}, {{{0, 0, 0}, J4}, same}}},
          true},
      Row{{{{2, 0, 2}, {2, 2, 2}, {1, 1, 3}, {1, 1, 1}}},
          {{{{{0, 0, 0}, I4}, same}, {{{0, -2, 0}, I1}, flip},
            {{{0, 0, 0}, J2}, same}, {{{0, 0, 0}, J3}, same}}},
          false},
      Row{{{{2, 2, 0}, {2, 2, 2}, {3, 1, 1}, {3, 3, 1}}},
          {{{{{2, 0, 0}, I2}, flip}, {{{2, 0, -2}, I3}, same},
            {{{0, 0, 0}, K3}, same}, {{{0, 0, 0}, K2}, same}}},
          true},
      Row{{{{2, 2, 0}, {2, 2, 2}, {3, 1, 1}, {1, 1, 1}}},
          {{{{{0, 0, 0}, J2}, same}, {{{0, 0, -2}, J3}, flip},
            {{{0, 0, 0}, K4}, same}, {{{0, 0, 0}, K1}, same}}},
          false},
      Row{{{{2, 2, 0}, {2, 2, 2}, {1, 3, 1}, {3, 3, 1}}},
          {{{{{0, 2, 0}, J2}, flip}, {{{0, 2, -2}, J3}, same},
            {{{0, 0, 0}, K1}, same}, {{{0, 0, 0}, K4}, same}}},
          false},
      Row{{{{2, 2, 0}, {2, 2, 2}, {1, 3, 1}, {1, 1, 1}}},
          {{{{{0, 0, 0}, I2}, same}, {{{0, 0, -2}, I3}, flip},
            {{{0, 0, 0}, K2}, same}, {{{0, 0, 0}, K3}, same}}},
          true},
  }};
}();

/// The bounds of `structured_tet`, and of what the engine takes for a lattice: all
/// coordinates stay in range (`CornersInRange`, `DoorSuffices` of the certificate).
inline constexpr std::int32_t anchor_limit = coordinate_limit - 8;

/// The tetrahedron of an identifier: `GetStructuredTet` of the certificate.
/// \throws Error `too_large` if the anchor has a coordinate beyond
/// ±anchor_limit.
constexpr StructuredTet structured_tet(const StructuredTetId& id) {
  const auto in_range = [](std::int32_t c) { return -anchor_limit <= c && c <= anchor_limit; };
  if (!in_range(id.anchor.x) || !in_range(id.anchor.y) || !in_range(id.anchor.z))
    throw Error(ErrorCode::too_large, "the lattice coordinate is out of range");
  const StructuredTetShape& shape =
      structured_tet_table[static_cast<std::size_t>(id.orientation)];
  StructuredTet tet{shape.vertices, shape.neighbors};
  for (Coord3& v : tet.vertices) v = id.anchor + v;
  for (FaceNeighbor& n : tet.neighbors) n.id.anchor = id.anchor + n.id.anchor;
  return tet;
}

/// Whether the case has positive volume in its own vertex order; the output of
/// the others is mirrored (`CaseHandedness`).
constexpr bool right_handed(StructuredTetCase orientation) {
  return structured_tet_table[static_cast<std::size_t>(orientation)].right_handed;
}

}  // namespace certet
