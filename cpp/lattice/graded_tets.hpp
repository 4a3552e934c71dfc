#pragma once
/// \file
/// The tetrahedra of graded interiors, by flags: `Grading/Flag.v` and
/// `Grading/GradedTet.v` of the certificate, in its names.
///
/// A flag is a cell's centre, the middle of one of its faces, the middle of one of that
/// face's edges, and one of that edge's ends.  A cell has 48, six in each of its eight
/// places for a child; what exists beside a flag tells which kind of tetrahedron has it.

#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/coord3.hpp"

namespace certet::core {

enum class GradedKind : std::uint8_t { bcc, edge_half, face_half, quarter, pyramid };
inline constexpr std::array<GradedKind, 5> graded_kinds{
    GradedKind::bcc, GradedKind::edge_half, GradedKind::face_half, GradedKind::quarter,
    GradedKind::pyramid};

/// A flag of a cell, whichever cell.
struct Flag {
  std::array<std::uint8_t, 3> axes;  ///< of the face, of the edge's place in it, of the edge
  std::array<bool, 3> up;            ///< along each: whether on the upper side

  /// Seen from the flag, coordinates count from the cell's centre towards face, edge and
  /// corner; in half sides of the cell.
  [[nodiscard]] constexpr Coord3 step_from(int a, int b, int c) const {
    const std::array<int, 3> seen{up[0] ? a : -a, up[1] ? b : -b, up[2] ? c : -c};
    std::array<std::int32_t, 3> step{};
    for (std::size_t n = 0; n < 3; ++n) step[axes[n]] = seen[n];
    return {step[0], step[1], step[2]};
  }
  [[nodiscard]] constexpr bool is_even_order() const {
    return (axes[0] + 1) % 3 == axes[1];
  }
};

inline constexpr std::size_t flag_count = 48;

inline constexpr std::array<Flag, flag_count> flags = [] {
  constexpr std::array<std::array<std::uint8_t, 3>, 6> orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  std::array<Flag, flag_count> list{};
  for (std::size_t n = 0; n < flag_count; ++n)
    list[n] = {orders[n / 8], {(n & 1) != 0, (n & 2) != 0, (n & 4) != 0}};
  return list;
}();

/// Whether a tetrahedron of a kind other than a pyramid has its name from the flag: of its
/// flags the one in the lower cell and at the upper corner.
constexpr bool names_tet(GradedKind kind, const Flag& flag) {
  switch (kind) {
    case GradedKind::bcc: return flag.up[0] && flag.up[2];
    case GradedKind::edge_half: return flag.up[0];
    case GradedKind::face_half: return flag.up[2];
    default: return true;
  }
}

/// The vertices of the tetrahedron that a flag names, from the cell's centre, in half sides;
/// in the order of a positive volume: `GetGradedTet`.
constexpr std::array<Coord3, 4> graded_tet(GradedKind kind, const Flag& flag) {
  const auto at = [&flag](int a, int b, int c) { return flag.step_from(a, b, c); };
  const auto [s, t, u] = flag.up;
  std::array<Coord3, 4> tet{};
  switch (kind) {
    case GradedKind::bcc:
      tet = {at(1, 1, -1), at(1, 1, 1), t ? at(2, 0, 0) : at(0, 0, 0),
             t ? at(0, 0, 0) : at(2, 0, 0)};
      break;
    case GradedKind::edge_half:
      tet = {at(1, 1, 1), at(1, 1, 0), at(2, 0, 0), at(0, 0, 0)};
      break;
    case GradedKind::face_half:
      tet = {at(1, 1, 1), at(1, 1, -1), at(1, 0, 0), at(0, 0, 0)};
      break;
    case GradedKind::quarter:
      tet = {at(1, 1, 1), at(1, 1, 0), at(1, 0, 0), at(0, 0, 0)};
      break;
    case GradedKind::pyramid:
      tet = {at(1, 1, 1), at(1, 1, -1), at(1, -1, 1), at(0, 0, 0)};
      break;
  }
  const bool right_handed = kind == GradedKind::bcc ? flag.is_even_order() != (s == u)
                                                    : flag.is_even_order() == (s == (t == u));
  return right_handed ? tet : std::array{tet[0], tet[1], tet[3], tet[2]};
}

/// By kind and flag.
inline constexpr auto graded_tets = [] {
  std::array<std::array<std::array<Coord3, 4>, flag_count>, graded_kinds.size()> table{};
  for (const GradedKind kind : graded_kinds)
    for (std::size_t n = 0; n < flag_count; ++n)
      table[static_cast<std::size_t>(kind)][n] = graded_tet(kind, flags[n]);
  return table;
}();

}  // namespace certet::core
