#pragma once
/// \file
/// The tetrahedra of a structured one where diagonals follow the cuts, written from the rule
/// and not from a table; and with the defects that the tests must refuse.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/stencil.hpp"

namespace diagonals {

using certet::Coord3;
using certet::Sign;

/// How a diagonal is chosen.
enum class Choice : std::uint8_t {
  parity,       ///< the paper's rule
  lesser,       ///< it ends at the lesser cut
  greater,      ///< at the greater, a defect
  other_ties,   ///< of equal cuts it ends at the other one, a defect
  from_minus,   ///< cuts are measured from their - ends, a defect
};

/// Among cuts at the same part of their edges: those of long edges come first, then of the short
/// ones from an even point those that step along (1, 1, 1) an even number of times against it,
/// from an odd point the others.
constexpr int rank_of_edge(Coord3 plus, Coord3 minus) {
  const Coord3 d = minus - plus;
  if (d.x % 2 == 0) return 0;
  const bool from_even = (plus.x & 1) == 0;
  return from_even == (d.x * d.y * d.z == 1) ? 1 : 2;
}

/// A vertex of the output: a lattice point twice, or the + and the - end of a cut edge.
using Place = std::pair<Coord3, Coord3>;
using PlacedTets = std::vector<std::array<Place, 4>>;

/// In any orientation.  `cut(plus, minus)` is in steps from the + end.
template <class Cut>
PlacedTets tets_of(const std::array<Coord3, 4>& corners, const certet::CornerSigns& signs,
                   Choice choice, const Cut& cut) {
  const auto corner = [](Coord3 c) { return Place{c, c}; };
  const auto those = [&](Sign sign) {
    std::vector<Coord3> found;
    for (std::size_t n = 0; n < 4; ++n)
      if (signs[n] == sign) found.push_back(corners[n]);
    return found;
  };
  const auto before = [&](const Place& a, const Place& b) {
    std::int32_t at_a = cut(a.first, a.second);
    std::int32_t at_b = cut(b.first, b.second);
    if (choice == Choice::greater || choice == Choice::from_minus) std::swap(at_a, at_b);
    if (at_a != at_b) return at_a < at_b;
    const int rank_a = rank_of_edge(a.first, a.second);
    const int rank_b = rank_of_edge(b.first, b.second);
    return choice == Choice::lesser || choice == Choice::from_minus ? rank_a < rank_b
                                                                    : rank_b < rank_a;
  };
  std::vector<Coord3> plus = those(Sign::plus);
  const std::vector<Coord3> minus = those(Sign::minus);
  const std::vector<Coord3> zero = those(Sign::on_surface);
  PlacedTets made;
  if (choice == Choice::parity || plus.size() < 2 || minus.empty()) {
    for (const certet::UnstructuredTet& tet : certet::unstructured_tets(signs)) {
      auto& placed = made.emplace_back();
      for (std::size_t n = 0; n < 4; ++n) placed[n] = {corners[tet[n].a], corners[tet[n].b]};
    }
    return made;
  }
  if (plus.size() == 2 && minus.size() == 2) {
    const auto first_towards = [&](Coord3 m) {
      return before({plus[0], m}, {plus[1], m}) ? plus[0] : plus[1];
    };
    Coord3 e = minus[0], f = minus[1];
    const Coord3 b = first_towards(e);
    const Coord3 a = b == plus[0] ? plus[1] : plus[0];
    const Place pa = corner(a), pb = corner(b);
    if (first_towards(f) == a) {
      made = {{pa, pb, {b, e}, {a, f}}, {pa, {b, e}, {a, e}, {a, f}}, {pb, {b, e}, {a, f}, {b, f}}};
    } else {
      if (before({b, e}, {b, f})) std::swap(e, f);
      made = {{pa, pb, {b, e}, {b, f}}, {pa, {b, e}, {a, f}, {b, f}}, {pa, {b, e}, {a, e}, {a, f}}};
    }
    return made;
  }
  const Coord3 e = minus[0];
  std::ranges::sort(plus, [&](Coord3 a, Coord3 b) { return before({a, e}, {b, e}); });
  const Place a = corner(plus[0]), b = corner(plus[1]);
  const Place cut_a{plus[0], e}, cut_b{plus[1], e};
  if (plus.size() == 2) {
    made = {{b, a, cut_a, corner(zero[0])}, {b, cut_a, cut_b, corner(zero[0])}};
  } else {
    const Place c = corner(plus[2]);
    made = {{c, b, a, cut_a}, {c, b, cut_a, cut_b}, {c, cut_a, cut_b, {plus[2], e}}};
  }
  return made;
}

}  // namespace diagonals
