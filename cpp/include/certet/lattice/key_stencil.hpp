#pragma once
/// \file
/// Stencils whose diagonals follow the cuts: on a face with two + corners and a - one the
/// diagonal of the quadrilateral ends at the lesser cut, that which is nearer to its + corner
/// in parts of its edge.  Among equal ones a long edge's comes first, then the Parity Rule
/// decides, so that with equal cuts these are the stencils of the paper.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/stencil.hpp"

namespace certet {

/// Two cuts of a structured tetrahedron; the first is the lesser if they are equal.
struct CutPair {
  StencilVertex first{}, second{};
  friend constexpr bool operator==(const CutPair&, const CutPair&) = default;
};

/// The orders of a pattern's cuts: bit n of an order is set if of pair n the second cut is
/// the lesser.
inline constexpr std::size_t cut_order_count = 16;

/// What is to be known of the cuts to choose a stencil, by the signs alone.
struct CutOrders {
  std::uint8_t pair_count = 0;
  std::array<CutPair, 4> pairs{};
  /// Which of `key_stencil_table`, by the order; of an order that no cuts have, the first.
  std::array<std::uint8_t, cut_order_count> stencil{};
};

/// All stencils: an empty one, and of 65 patterns one for each order that matters.
inline constexpr std::size_t key_stencil_count = 128;

namespace key_detail {

/// A pattern and the comparisons, `14<24`, that a stencil belongs to; others are images by
/// any permutation of the corners.
struct Representative {
  stencil_detail::Representative stencil;
  const char* order;
};

inline constexpr std::array<Representative, 4> representatives{{
    {{"++0-", "2 1 14 3 | 2 14 24 3"}, "14<24"},
    {{"+++-", "2 1 34 3 | 2 1 14 34 | 2 14 24 34"}, "34<14 14<24"},
    {{"++--", "1 2 23 14 | 1 23 13 14 | 2 23 14 24"}, "23<13 14<24"},
    // Where both faces' diagonals end at one corner, the quadrilateral within the
    // tetrahedron is free to choose: its diagonal ends at the greater of that corner's cuts.
    {{"++--", "1 2 23 24 | 1 23 14 24 | 1 23 13 14"}, "23<13 24<14 24<23"},
}};

using Corners = std::array<std::uint8_t, 4>;

/// All permutations, in lexicographic order.
inline constexpr std::array<Corners, 24> permutations = [] {
  std::array<Corners, 24> all{};
  Corners next{0, 1, 2, 3};
  for (Corners& one : all) {
    one = next;
    std::next_permutation(next.begin(), next.end());
  }
  return all;
}();

constexpr bool is_even(const Corners& p) {
  int inversions = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) inversions += p[j] > p[i] ? 1 : 0;
  return inversions % 2 == 0;
}

/// Among equal cuts the lesser number comes first: long edges v1 v2 and v3 v4, then the
/// short ones v1 v4 and v2 v3, at which the diagonals of the Parity Rule end.
constexpr int rank_among_equals(StencilVertex cut) {
  if (cut.a / 2 == cut.b / 2) return 0;
  return (cut.a + cut.b) % 2 == 1 ? 1 : 2;
}

constexpr CutPair pair_of(StencilVertex a, StencilVertex b) {
  return rank_among_equals(a) < rank_among_equals(b) ? CutPair{a, b} : CutPair{b, a};
}

/// The pairs to be compared: the two cuts of every face that has a quadrilateral and, where
/// two corners are + and two -, those of either + corner.
constexpr CutOrders pairs_of(const CornerSigns& signs) {
  CutOrders orders;
  std::array<std::uint8_t, 4> plus{}, minus{};
  std::size_t plus_count = 0, minus_count = 0;
  for (std::uint8_t c = 0; c < 4; ++c) {
    if (signs[c] == Sign::plus) plus[plus_count++] = c;
    if (signs[c] == Sign::minus) minus[minus_count++] = c;
  }
  const auto add = [&](StencilVertex a, StencilVertex b) {
    orders.pairs[orders.pair_count++] = pair_of(a, b);
  };
  for (std::size_t m = 0; m < minus_count; ++m)
    for (std::size_t q = 1; q < plus_count; ++q)
      for (std::size_t p = 0; p < q; ++p)
        add({plus[p], minus[m]}, {plus[q], minus[m]});
  if (plus_count == 2 && minus_count == 2)
    for (std::size_t p = 0; p < 2; ++p) add({plus[p], minus[0]}, {plus[p], minus[1]});
  return orders;
}

/// Whether the first of two cuts is the lesser, by the order of the pairs.
constexpr bool is_lesser(const CutOrders& orders, std::size_t order, StencilVertex a,
                         StencilVertex b) {
  for (std::size_t n = 0; n < orders.pair_count; ++n) {
    const bool turned = (order >> n & 1) != 0;
    if (orders.pairs[n] == CutPair{a, b}) return !turned;
    if (orders.pairs[n] == CutPair{b, a}) return turned;
  }
  return false;
}

/// Whether some cuts have this order.  The pairs go round in a circle, if there are more than
/// one: just where each cut is the greater of one of its pairs there is no least.
constexpr bool is_possible(const CutOrders& orders, std::size_t order) {
  for (std::size_t n = 0; n < orders.pair_count; ++n) {
    const auto& [first, second] = orders.pairs[n];
    const StencilVertex lesser = (order >> n & 1) != 0 ? second : first;
    bool is_least = true;
    for (std::size_t m = 0; m < orders.pair_count; ++m)
      is_least = is_least && lesser != ((order >> m & 1) != 0 ? orders.pairs[m].first
                                                              : orders.pairs[m].second);
    if (is_least) return true;
  }
  return false;
}

/// Whether a permutation carries the representative to these signs and this order.
constexpr bool carries(const Representative& r, const Corners& g, const CornerSigns& signs,
                       const CutOrders& orders, std::size_t order) {
  if (!stencil_detail::carries(r.stencil, g, signs)) return false;
  const auto cut = [&](const char* at) {
    return StencilVertex{g[stencil_detail::corner_of(at[0])], g[stencil_detail::corner_of(at[1])]};
  };
  for (const char* c = r.order;; c += 6) {
    if (!is_lesser(orders, order, cut(c), cut(c + 3))) return false;
    if (c[5] == '\0') return true;
  }
}

/// The stencil of these signs and this order; where no cuts have that order, none.
constexpr Stencil make_stencil(const CornerSigns& signs, const CutOrders& orders,
                               std::size_t order) {
  if (orders.pair_count == 0) return stencil_detail::make_stencil(signs);
  if (!is_possible(orders, order)) return {};
  for (const Corners& g : permutations)
    for (const Representative& r : representatives)
      if (carries(r, g, signs, orders, order)) {
        Stencil stencil = stencil_detail::image(r.stencil, g, signs);
        if (!is_even(g))
          for (std::size_t n = 0; n < stencil.count; ++n)
            std::swap(stencil.tets[n][2], stencil.tets[n][3]);
        return stencil;
      }
  return {};
}

struct Tables {
  std::array<CutOrders, pattern_count> orders{};
  std::array<Stencil, key_stencil_count> stencils{};
  std::size_t count = 1;

  constexpr std::uint8_t number_of(const Stencil& stencil, std::size_t first) {
    if (stencil.count == 0) return static_cast<std::uint8_t>(first == count ? 0 : first);
    std::size_t n = first;
    while (n < count && stencils[n] != stencil) ++n;
    if (n == count) stencils[count++] = stencil;
    return static_cast<std::uint8_t>(n);
  }
};

inline constexpr Tables tables = [] {
  Tables made;
  for (int index = 0; index < pattern_count; ++index) {
    const CornerSigns signs = pattern_signs(index);
    CutOrders& orders = made.orders[static_cast<std::size_t>(index)];
    orders = pairs_of(signs);
    const std::size_t first = made.count;
    for (std::size_t order = 0; order < std::size_t{1} << orders.pair_count; ++order)
      orders.stencil[order] = made.number_of(make_stencil(signs, orders, order), first);
  }
  return made;
}();

}  // namespace key_detail

/// Of each pattern, indexed by pattern_index.
inline constexpr std::array<CutOrders, pattern_count> cut_orders = key_detail::tables.orders;
/// The stencils, pattern by pattern.
inline constexpr std::array<Stencil, key_stencil_count> key_stencil_table =
    key_detail::tables.stencils;

static_assert(key_detail::tables.count == key_stencil_count);

}  // namespace certet
