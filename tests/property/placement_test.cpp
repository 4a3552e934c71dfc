/// \file
/// Every placement that warping admits of one structured tetrahedron: whatever
/// directions its vertices moved in, at the corners of the ranges of their
/// parameters and inside, all volumes are positive and all dihedral angles in
/// the proven range.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <functional>

#include "certet/lattice/direction.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/lattice/warp.hpp"
#include "exact.hpp"
#include "stencils.hpp"

namespace {

using namespace certet;

using Corners = std::array<Coord3, 4>;

/// The signs after warping, and the direction in which each vertex of sign 0
/// moved (others: -1).
struct Configuration {
  CornerSigns signs;
  std::array<int, 4> direction;
};

/// The corner to which corner i moves, or -1 if the edge leaves the tetrahedron.
int target(const Corners& corners, const Configuration& c, int i) {
  const auto at = static_cast<std::size_t>(i);
  if (c.direction[at] < 0) return -1;
  const Coord3 end =
      corners[at] + certet::direction_offset[static_cast<std::size_t>(c.direction[at])];
  for (int j = 0; j < 4; ++j)
    if (corners[static_cast<std::size_t>(j)] == end) return j;
  return -1;
}

/// A vertex moves towards one that had the opposite sign, and never do two move
/// along one edge: so no ring of vertices each moving to the next is possible
/// but an even one of four.
bool admissible(const Corners& corners, const Configuration& c) {
  for (int i = 0; i < 4; ++i) {
    int j = target(corners, c, i);
    for (int length = 1; j >= 0; ++length) {
      if (j == i && (length == 2 || length % 2 == 1)) return false;
      if (length == 4) break;
      j = target(corners, c, j);
    }
  }
  return true;
}

/// All configurations that leave a tetrahedron.
std::vector<Configuration> configurations(const Corners& corners) {
  std::vector<Configuration> all;
  const std::function<void(Configuration&, std::size_t)> choose = [&](Configuration& c,
                                                                      std::size_t i) {
    if (i == 4) {
      if (admissible(corners, c)) all.push_back(c);
      return;
    }
    if (c.signs[i] != Sign::on_surface) return choose(c, i + 1);
    for (c.direction[i] = 0; c.direction[i] < certet::direction_count; ++c.direction[i])
      choose(c, i + 1);
    c.direction[i] = -1;
  };
  for (int pattern = 0; pattern < certet::pattern_count; ++pattern) {
    Configuration c{certet::pattern_signs(pattern), {-1, -1, -1, -1}};
    if (production(c.signs).count > 0) choose(c, 0);
  }
  return all;
}

int direction_between(Coord3 from, Coord3 to) {
  for (int d = 0; d < certet::direction_count; ++d)
    if (from + certet::direction_offset[static_cast<std::size_t>(d)] == to) return d;
  return -1;
}

/// The range of the parameter of a vertex, in 256ths of an edge.
struct Range {
  Coord3 start, along;
  std::int32_t low, high;
};

Range range_of(const Corners& corners, const Configuration& c, Thresholds th, StencilVertex v) {
  const auto alpha = [&](int d) { return certet::is_long(d) ? th.long_edge : th.short_edge; };
  if (v.is_cut()) {
    const std::int32_t a = alpha(direction_between(corners[v.a], corners[v.b]));
    return {corners[v.a], corners[v.b] - corners[v.a], a, 256 - a};
  }
  const int d = c.direction[v.a];
  if (d < 0) return {corners[v.a], {0, 0, 0}, 0, 0};
  return {corners[v.a], certet::direction_offset[static_cast<std::size_t>(d)], 0, alpha(d)};
}

/// Visits the tetrahedra of a configuration, right-handed, as the ranges of their
/// vertices.
template <class Visit>
void for_each_tet(const Stencils& stencils, const Corners& corners, bool right_handed,
                  const Configuration& c, Thresholds th, const Visit& visit) {
  for (certet::UnstructuredTet tet : stencils(c.signs)) {
    if (!right_handed) std::swap(tet[2], tet[3]);
    std::array<Range, 4> ranges{};
    for (std::size_t i = 0; i < 4; ++i) ranges[i] = range_of(corners, c, th, tet[i]);
    visit(ranges);
  }
}

struct Extremes {
  long configurations = 0, functions = 0, outside = 0;
  long double smallest = 180, largest = 0;

  void measure(const exact::Tet& tet, const exact::AngleRange& proven) {
    for (const exact::Dihedral& angle : exact::dihedrals(tet)) {
      if (!proven.contains(angle)) ++outside;
      smallest = std::min(smallest, angle.degrees());
      largest = std::max(largest, angle.degrees());
    }
  }
};

/// All corners of all parameter boxes of one case.
Extremes extremes(const Stencils& stencils, certet::StructuredTetCase orientation, Thresholds th,
                  const exact::AngleRange& proven) {
  const Corners corners = certet::structured_tet({{0, 0, 0}, orientation}).vertices;
  Extremes found;
  for (const Configuration& c : configurations(corners)) {
    ++found.configurations;
    for_each_tet(stencils, corners, certet::right_handed(orientation), c, th,
                 [&](const std::array<Range, 4>& ranges) {
      found.functions += 6;
      for (unsigned choice = 0; choice < 16; ++choice) {
        exact::Tet tet;
        bool repeated = false;
        for (std::size_t i = 0; i < 4; ++i) {
          const Range& r = ranges[i];
          const bool high = (choice >> i & 1U) != 0;
          repeated = repeated || (high && r.low == r.high);
          tet[i] = 256 * r.start + (high ? r.high : r.low) * r.along;
        }
        if (!repeated) found.measure(tet, proven);
      }
    });
  }
  return found;
}

class EveryCase : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] certet::StructuredTetCase orientation() const {
    return static_cast<certet::StructuredTetCase>(GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(Placement, EveryCase, testing::Range(0, certet::case_count),
                         [](const auto& info) {
                           return std::string(
                               certet::case_names[static_cast<std::size_t>(info.param)]);
                         });

TEST_P(EveryCase, KeepsTheRangeOfAngles) {
  const Extremes found = extremes(production, orientation(), certet::angle_thresholds,
                                  exact::angles_range);
  EXPECT_EQ(found.configurations, 14'717);
  EXPECT_EQ(found.functions, 89'430);
  EXPECT_EQ(found.outside, 0);
  // The bounds are attained to a hundredth of a degree.
  EXPECT_LT(found.smallest, 10.78L);
  EXPECT_GT(found.largest, 164.75L);
}

TEST_P(EveryCase, KeepsTheRangeOfEmbedding) {
  const Extremes found = extremes(production, orientation(), certet::embedding_thresholds,
                                  exact::embedding_range);
  EXPECT_EQ(found.outside, 0);
  EXPECT_LT(found.smallest, 9.28L);
  EXPECT_GT(found.largest, 161.45L);
}

/// Parameters inside the boxes, to one step.
TEST(Placement, KeepsTheRangesInsideTheBoxes) {
  struct Proven {
    Thresholds thresholds;
    exact::AngleRange range;
  };
  const Proven both[] = {{certet::angle_thresholds, exact::angles_range},
                         {certet::embedding_thresholds, exact::embedding_range}};
  const certet::StructuredTetCase orientation = certet::StructuredTetCase::I1;
  const Corners corners = certet::structured_tet({{0, 0, 0}, orientation}).vertices;
  const std::vector<Configuration> all = configurations(corners);
  EXPECT_TRUE(rc::check("random parameters keep the range", [&] {
    for (int trial = 0; trial < 500; ++trial)
      for (const Proven& proven : both) {
        const Configuration& c = all[*rc::gen::inRange<std::size_t>(0, all.size())];
        for_each_tet(production, corners, certet::right_handed(orientation), c,
                     proven.thresholds, [&](const std::array<Range, 4>& ranges) {
          exact::Tet tet;
          for (std::size_t i = 0; i < 4; ++i) {
            const Range& r = ranges[i];
            const std::int32_t t = *rc::gen::inRange(r.low * 256, r.high * 256 + 1);
            tet[i] = certet::steps * r.start + t * r.along;
          }
          for (const exact::Dihedral& angle : exact::dihedrals(tet))
            RC_ASSERT(proven.range.contains(angle));
        });
      }
  }));
}

TEST(Placement, CatchesAThresholdThatIsTooWide) {
  const Extremes found = extremes(production, certet::StructuredTetCase::I1, {74, 102},
                                  exact::angles_range);
  EXPECT_GT(found.outside, 0);
}

TEST(Placement, CatchesASwappedDiagonal) {
  // 0++- leaves the quadrilateral v2 v3 m34 m24; v3 v4 is long, v2 v4 short.
  const Stencils broken = [](const CornerSigns& signs) {
    constexpr CornerSigns pattern{Sign::on_surface, Sign::plus, Sign::plus, Sign::minus};
    if (signs != pattern) return production(signs);
    const StencilVertex v1{0, 0}, v2{1, 1}, v3{2, 2}, m24{1, 3}, m34{2, 3};
    return Stencil{2, {{{v2, v3, v1, m24}, {v3, m34, v1, m24}}}};
  };
  const Extremes found = extremes(broken, certet::StructuredTetCase::I1,
                                  certet::angle_thresholds, exact::angles_range);
  EXPECT_GT(found.outside, 0);
}

}  // namespace
