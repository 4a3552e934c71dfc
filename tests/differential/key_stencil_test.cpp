/// \file
/// The stencils whose diagonals follow the cuts: all sign patterns at all twelve structured
/// tetrahedra, in all orders of their cuts, equal ones too.

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "certet/lattice/key_stencil.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "property/key_diagonals.hpp"
#include "vertex_arena.hpp"

namespace {

using certet::Coord3;
using certet::CornerSigns;
using certet::Sign;
using certet::Stencil;
using certet::StencilVertex;
using certified::Handle;

using Corners = std::array<Coord3, 4>;

/// Where each edge is cut, from its + end: some number, by its corners.
using CutOf = std::function<int(std::size_t plus, std::size_t minus)>;

/// The production side.
struct Production {
  std::array<Stencil, certet::key_stencil_count> stencils = certet::key_stencil_table;
  std::array<certet::CutOrders, certet::pattern_count> orders = certet::cut_orders;
  std::function<int(int)> seen = [](int cut) { return cut; };

  [[nodiscard]] const Stencil& stencil(const CornerSigns& signs, const CutOf& cut) const {
    const auto& of_pattern = orders[static_cast<std::size_t>(certet::pattern_index(signs))];
    std::size_t order = 0;
    for (std::size_t n = 0; n < of_pattern.pair_count; ++n) {
      const auto& [first, second] = of_pattern.pairs[n];
      order |= std::size_t{seen(cut(second.a, second.b)) < seen(cut(first.a, first.b))} << n;
    }
    return stencils[of_pattern.stencil[order]];
  }
};

PlacedTets certified_tets(const CornerSigns& signs, const CutOf& cut, const Corners& corners) {
  VertexArena arena(corners);
  const auto corner = VertexArena::corner;
  return arena.placed(certified::key_tets(
      [&](Handle h) { return signs[corner(h)]; },
      [&](Handle a, Handle b) { return arena.cut(a, b); },
      [&](Handle a, Handle b) {
        return std::int64_t{3} * cut(corner(a), corner(b)) +
               diagonals::rank_of_edge(corners[corner(a)], corners[corner(b)]);
      },
      {0, 1, 2, 3}));
}

/// Cuts at one of four places each: all orders of four cuts, and of those that are equal.
void compare_pattern(const Production& production, const CornerSigns& signs,
                     const Corners& corners, Differences& differences) {
  std::array<std::array<std::size_t, 4>, 4> number{};
  std::size_t count = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b)
      if (signs[a] == Sign::plus && signs[b] == Sign::minus) number[a][b] = count++;
  for (std::size_t all = 0; all < std::size_t{1} << 2 * count; ++all) {
    const CutOf cut = [&](std::size_t plus, std::size_t minus) {
      return static_cast<int>(all >> 2 * number[plus][minus] & 3);
    };
    differences.expect(place(production.stencil(signs, cut), corners) ==
                           certified_tets(signs, cut, corners),
                       [&] {
                         std::string text = "signs ";
                         for (const Sign s : signs) text += "-0+"[static_cast<int>(s)];
                         return text + ", cuts " + std::to_string(all);
                       });
  }
}

Differences compare(const Production& production) {
  Differences differences;
  for (const certet::StructuredTetCase orientation : certified::all_cases()) {
    const Corners corners = certified::structured_tet({{0, 0, 0}, orientation}).vertices;
    for (int pattern = 0; pattern < certet::pattern_count; ++pattern)
      compare_pattern(production, certet::pattern_signs(pattern), corners, differences);
  }
  return differences;
}

TEST(KeyStencil, IsTheSameForAllPatternsAndOrders) {
  const Differences differences = compare({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GT(differences.compared(), 12 * (6 * 256 + 8 * 64 + 67));
}

/// Wherever two cuts are equal the paper's stencil is taken.
TEST(KeyStencil, IsThePapersWhereCutsAreEqual) {
  for (int pattern = 0; pattern < certet::pattern_count; ++pattern) {
    const CornerSigns signs = certet::pattern_signs(pattern);
    EXPECT_EQ(Production{}.stencil(signs, [](std::size_t, std::size_t) { return 7; }),
              certet::unstructured_tets(signs));
  }
}

TEST(KeyStencil, CatchesASwappedDiagonal) {
  for (std::size_t n = 0; n < certet::key_stencil_count; ++n) {
    Production broken;
    Stencil& stencil = broken.stencils[n];
    if (stencil.count != 2) continue;
    // b a A z and b A B z: here a B A z and b a B z.
    const StencilVertex b = stencil.tets[0][0];
    for (StencilVertex& v : stencil.tets[1])
      if (v == b) v = {};
    EXPECT_FALSE(compare(broken).empty()) << n;
    break;
  }
}

TEST(KeyStencil, CatchesTiesTheOtherWay) {
  Production broken;
  for (certet::CutOrders& orders : broken.orders)
    for (std::size_t n = 0; n < orders.pair_count; ++n) {
      std::swap(orders.pairs[n].first, orders.pairs[n].second);
      // The order that is not equal stays the same.
      auto stencils = orders.stencil;
      for (std::size_t order = 0; order < certet::cut_order_count; ++order)
        orders.stencil[order] = stencils[order ^ (std::size_t{1} << n)];
    }
  EXPECT_FALSE(compare(broken).empty());
}

TEST(KeyStencil, CatchesCutsFromTheWrongEnd) {
  EXPECT_FALSE(compare({.seen = [](int cut) { return 3 - cut; }}).empty());
}

}  // namespace
