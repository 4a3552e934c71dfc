#pragma once
/// \file
/// The stencils: how signs turn a structured tetrahedron into the tetrahedra of
/// the output (section 3.2 of the paper).  Picture: cpp/docs/pictures/stencils.svg.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "certet/lattice/sign.hpp"

namespace certet {

/// A vertex of a stencil: corner `a` of the structured tetrahedron (a == b), or
/// the cut of the edge from its + corner `a` to its - corner `b`.  Corners are
/// numbered from 0.
struct StencilVertex {
  std::uint8_t a, b;
  [[nodiscard]] constexpr bool is_cut() const { return a != b; }
  friend constexpr bool operator==(const StencilVertex&, const StencilVertex&) = default;
};

/// Right-handed when the structured tetrahedron is.
using UnstructuredTet = std::array<StencilVertex, 4>;

/// Zero to three tetrahedra.
struct Stencil {
  std::uint8_t count = 0;
  std::array<UnstructuredTet, 3> tets{};

  [[nodiscard]] constexpr const UnstructuredTet* begin() const { return tets.data(); }
  [[nodiscard]] constexpr const UnstructuredTet* end() const { return tets.data() + count; }
  friend constexpr bool operator==(const Stencil&, const Stencil&) = default;
};

using CornerSigns = std::array<Sign, 4>;

inline constexpr int pattern_count = 81;

/// Numbers the 81 sign patterns: sum of sign(i) * 3^i, - 0 + being 0 1 2.
constexpr int pattern_index(Sign s0, Sign s1, Sign s2, Sign s3) {
  return static_cast<int>(s0) + 3 * static_cast<int>(s1) + 9 * static_cast<int>(s2) +
         27 * static_cast<int>(s3);
}

constexpr int pattern_index(const CornerSigns& s) {
  return pattern_index(s[0], s[1], s[2], s[3]);
}

constexpr CornerSigns pattern_signs(int index) {
  CornerSigns s{};
  for (Sign& sign : s) {
    sign = static_cast<Sign>(index % 3);
    index /= 3;
  }
  return s;
}

namespace stencil_detail {

/// A pattern of which the others are images, in the notation of the original
/// publication: signs of v1..v4, then each tetrahedron as four words, `3` for
/// corner v3 and `14` for the cut on v1 v4; tetrahedra are separated by `|`.
struct Representative {
  const char* signs;
  const char* tets;
};

inline constexpr std::array<Representative, 14> representatives{{
    {"+---", "1 12 13 14"},
    {"+0--", "1 2 13 14"},
    {"+-0-", "1 12 3 14"},
    {"+--0", "1 12 13 4"},
    {"+00-", "1 2 3 14"},
    {"+0-0", "1 2 13 4"},
    {"+-00", "1 12 3 4"},
    {"++0-", "2 1 14 3 | 2 14 24 3"},
    {"+0+-", "1 3 34 2 | 1 34 14 2"},
    {"0++-", "2 3 1 34 | 2 34 1 24"},
    {"++--", "1 2 23 14 | 1 23 13 14 | 2 23 14 24"},
    {"+-+-", "1 3 34 12 | 1 34 14 12 | 3 34 12 23"},
    {"+--+", "1 4 12 34 | 1 34 12 13 | 4 34 24 12"},
    {"+++-", "2 1 34 3 | 2 1 14 34 | 2 14 24 34"},
}};

/// The symmetries under which the stencils are invariant: the rotations of a
/// structured tetrahedron.  All are even, so handedness is kept.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> symmetries{
    {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};

constexpr Sign sign_of_char(char c) {
  return c == '+' ? Sign::plus : c == '-' ? Sign::minus : Sign::on_surface;
}

/// The corner that a digit names.
constexpr std::size_t corner_of(char digit) { return static_cast<std::size_t>(digit - '1'); }

/// Whether symmetry `g` carries the signs of the representative to `signs`.
constexpr bool carries(const Representative& r, const std::array<std::uint8_t, 4>& g,
                       const CornerSigns& signs) {
  for (std::size_t i = 0; i < 4; ++i)
    if (signs[g[i]] != sign_of_char(r.signs[i])) return false;
  return true;
}

/// The stencil of `signs`, read off the representative through `g`.
constexpr Stencil image(const Representative& r, const std::array<std::uint8_t, 4>& g,
                        const CornerSigns& signs) {
  Stencil stencil;
  std::size_t slot = 0;
  for (const char* c = r.tets; *c != '\0'; ++c) {
    if (*c == ' ' || *c == '|') continue;
    std::uint8_t a = g[corner_of(*c)];
    std::uint8_t b = a;
    if (c[1] >= '1' && c[1] <= '4') {
      b = g[corner_of(*++c)];
      if (signs[a] == Sign::minus) {
        const std::uint8_t plus = b;
        b = a;
        a = plus;
      }
    }
    stencil.tets[slot / 4][slot % 4] = {a, b};
    ++slot;
  }
  stencil.count = static_cast<std::uint8_t>(slot / 4);
  return stencil;
}

constexpr Stencil make_stencil(const CornerSigns& signs) {
  bool plus = false;
  bool minus = false;
  for (Sign s : signs) {
    plus = plus || s == Sign::plus;
    minus = minus || s == Sign::minus;
  }
  if (!plus) return {};
  if (!minus) return {1, {{{{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}}}};
  for (const auto& g : symmetries)
    for (const Representative& r : representatives)
      if (carries(r, g, signs)) return image(r, g, signs);
  return {};
}

}  // namespace stencil_detail

/// The stencil table, indexed by pattern_index.
inline constexpr std::array<Stencil, pattern_count> stencil_table = [] {
  std::array<Stencil, pattern_count> table{};
  for (int i = 0; i < pattern_count; ++i)
    table[static_cast<std::size_t>(i)] = stencil_detail::make_stencil(pattern_signs(i));
  return table;
}();

/// `GetUnstructuredTets` of the certificate.
constexpr const Stencil& unstructured_tets(const CornerSigns& signs) {
  return stencil_table[static_cast<std::size_t>(pattern_index(signs))];
}

}  // namespace certet
