#pragma once
/// \file
/// Other stencils: of the two diagonals of a quadrilateral between two + corners and
/// their cuts, the one from the corner that comes first.  They fit wherever the
/// tetrahedra on both sides of a face name its corners in the same order.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "certet/lattice/orientation.hpp"
#include "certet/lattice/stencil.hpp"

namespace certet::tilings {

/// Twice the place of a vertex in a tetrahedron of positive volume.
constexpr Coord3 place(StencilVertex v) {
  constexpr std::array<Coord3, 4> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return corner[v.a] + corner[v.b];
}

constexpr UnstructuredTet right_handed(UnstructuredTet t) {
  if (six_volume(place(t[0]), place(t[1]), place(t[2]), place(t[3])) < 0) std::swap(t[2], t[3]);
  return t;
}

constexpr Stencil ordered_stencil(const CornerSigns& signs) {
  std::array<std::array<std::uint8_t, 4>, 3> corners{};  // of each sign, in order
  std::array<std::size_t, 3> count{};
  for (std::uint8_t c = 0; c < 4; ++c) {
    const auto s = static_cast<std::size_t>(signs[c]);
    corners[s][count[s]++] = c;
  }
  const auto [minus, zero, plus] = count;
  const auto& m = corners[0];
  const auto& z = corners[1];
  const auto& p = corners[2];
  const auto at = [](std::uint8_t c) { return StencilVertex{c, c}; };
  const auto cut = [](std::uint8_t a, std::uint8_t b) { return StencilVertex{a, b}; };
  Stencil stencil;
  const auto add = [&](StencilVertex a, StencilVertex b, StencilVertex c, StencilVertex d) {
    stencil.tets[stencil.count++] = right_handed({a, b, c, d});
  };
  if (plus == 0) return stencil;
  if (minus == 0) {
    add(at(0), at(1), at(2), at(3));
  } else if (plus == 1) {
    UnstructuredTet tet{};
    for (std::uint8_t c = 0; c < 4; ++c)
      tet[c] = signs[c] == Sign::minus ? cut(p[0], c) : at(c);
    stencil = {1, {right_handed(tet)}};
  } else if (plus == 2 && zero == 1) {
    add(at(p[0]), at(p[1]), cut(p[1], m[0]), at(z[0]));
    add(at(p[0]), cut(p[1], m[0]), cut(p[0], m[0]), at(z[0]));
  } else if (plus == 2) {
    add(at(p[0]), at(p[1]), cut(p[1], m[0]), cut(p[1], m[1]));
    add(at(p[0]), cut(p[0], m[0]), cut(p[0], m[1]), cut(p[1], m[1]));
    add(at(p[0]), cut(p[0], m[0]), cut(p[1], m[1]), cut(p[1], m[0]));
  } else {
    add(at(p[0]), at(p[1]), at(p[2]), cut(p[2], m[0]));
    add(at(p[0]), at(p[1]), cut(p[1], m[0]), cut(p[2], m[0]));
    add(at(p[0]), cut(p[0], m[0]), cut(p[1], m[0]), cut(p[2], m[0]));
  }
  return stencil;
}

inline constexpr std::array<Stencil, pattern_count> ordered_stencils = [] {
  std::array<Stencil, pattern_count> table{};
  for (int i = 0; i < pattern_count; ++i)
    table[static_cast<std::size_t>(i)] = ordered_stencil(pattern_signs(i));
  return table;
}();

}  // namespace certet::tilings
