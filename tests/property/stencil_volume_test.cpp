/// \file
/// The stencil of a sign pattern and that of the opposite pattern share the
/// structured tetrahedron between them, without gap or overlap.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>

#include "certet/lattice/structured_tet.hpp"
#include "exact.hpp"
#include "stencils.hpp"

namespace {

using namespace certet;
using exact::Wide;

/// Steps from corner i to the cut on the edge to corner j > i.
using EdgeCuts = std::array<std::array<std::int32_t, 4>, 4>;

Coord3 position(const std::array<Coord3, 4>& corners, const EdgeCuts& cuts, StencilVertex v) {
  const std::size_t i = std::min(v.a, v.b);
  const std::size_t j = std::max(v.a, v.b);
  const Coord3 start = certet::steps * corners[i];
  return i == j ? start : start + cuts[i][j] * (corners[j] - corners[i]);
}

CornerSigns opposite(CornerSigns signs) {
  for (Sign& s : signs) s = static_cast<Sign>(2 - static_cast<int>(s));
  return signs;
}

/// An empty answer says that every tetrahedron of `signs` is positive and that
/// the two sides fill the whole.
std::string fault(const Stencils& stencils, certet::StructuredTetCase orientation,
                  const CornerSigns& signs, const EdgeCuts& cuts) {
  const auto corners = certet::structured_tet({{0, 0, 0}, orientation}).vertices;
  const int hand = certet::right_handed(orientation) ? 1 : -1;
  Wide sum = 0;
  for (const CornerSigns& side : {signs, opposite(signs)})
    for (const certet::UnstructuredTet& tet : stencils(side)) {
      exact::Tet placed;
      for (std::size_t i = 0; i < 4; ++i) placed[i] = position(corners, cuts, tet[i]);
      const Wide volume = hand * exact::six_volume(placed);
      if (volume <= 0) return "a tetrahedron is not positive";
      sum += volume;
    }
  constexpr Wide unit = certet::steps;
  if (sum != 4 * unit * unit * unit) return "the volumes do not add up";
  return "";
}

bool all_on_surface(const CornerSigns& signs) {
  return std::ranges::all_of(signs, [](Sign s) { return s == Sign::on_surface; });
}

bool fills(const Stencils& stencils) {
  return rc::check("a stencil and its opposite fill the tetrahedron", [&] {
    EdgeCuts cuts{};
    for (auto& row : cuts)
      for (std::int32_t& cut : row) cut = *rc::gen::inRange(1, certet::steps);
    for (int c = 0; c < certet::case_count; ++c)
      for (int pattern = 0; pattern < certet::pattern_count; ++pattern) {
        const CornerSigns signs = certet::pattern_signs(pattern);
        if (all_on_surface(signs)) continue;
        const std::string what =
            fault(stencils, static_cast<certet::StructuredTetCase>(c), signs, cuts);
        if (!what.empty()) RC_FAIL("pattern " + std::to_string(pattern) + ": " + what);
      }
  });
}

TEST(StencilVolume, FillsTheTetrahedron) { EXPECT_TRUE(fills(production)); }

TEST(StencilVolume, NinetySevenTetrahedra) {
  std::array<int, 4> patterns{};
  for (int i = 0; i < certet::pattern_count; ++i)
    ++patterns[production(certet::pattern_signs(i)).count];
  EXPECT_EQ(patterns, (std::array<int, 4>{16, 43, 12, 10}));
}

/// The production stencils, but for one pattern changed by `spoil`.
template <class Spoil>
Stencils with(const CornerSigns& pattern, const Spoil& spoil) {
  return [=](const CornerSigns& signs) {
    Stencil stencil = production(signs);
    if (signs == pattern) spoil(stencil);
    return stencil;
  };
}

constexpr Sign p = Sign::plus;
constexpr Sign m = Sign::minus;
constexpr Sign o = Sign::on_surface;

TEST(StencilVolume, CatchesAMissingTetrahedron) {
  EXPECT_FALSE(fills(with({p, p, m, m}, [](Stencil& s) { s.count = 2; })));
}

TEST(StencilVolume, CatchesAMirroredTetrahedron) {
  EXPECT_FALSE(fills(with({o, p, p, m}, [](Stencil& s) { std::swap(s.tets[0][2], s.tets[0][3]); })));
}

TEST(StencilVolume, CatchesACornerForACut) {
  EXPECT_FALSE(fills(with({p, m, m, m}, [](Stencil& s) { s.tets[0][1] = {1, 1}; })));
}

}  // namespace
