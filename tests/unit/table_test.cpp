/// \file
/// The small tables and functions of the public headers.

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "certet/lattice/direction.hpp"
#include "certet/error.hpp"
#include "certet/frame.hpp"
#include "certet/lattice/sign.hpp"
#include "certet/lattice/stencil.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/lattice/warp.hpp"

namespace {

using certet::Coord3;
using certet::Sign;

TEST(Direction, OppositesStandSideBySide) {
  for (std::size_t d = 0; d < certet::direction_count; ++d)
    EXPECT_EQ(certet::direction_offset[d] + certet::direction_offset[d ^ 1U], (Coord3{0, 0, 0}));
}

TEST(Direction, LengthsFit) {
  std::set<Coord3> different;
  for (int d = 0; d < certet::direction_count; ++d) {
    const Coord3 o = certet::direction_offset[static_cast<std::size_t>(d)];
    EXPECT_EQ(o.x * o.x + o.y * o.y + o.z * o.z, certet::length_squared(d));
    different.insert(o);
  }
  EXPECT_EQ(different.size(), 14U);
}

TEST(SignOf, ALevel) {
  EXPECT_EQ(certet::sign_of_level(-1), Sign::plus);
  EXPECT_EQ(certet::sign_of_level(0), Sign::on_surface);
  EXPECT_EQ(certet::sign_of_level(-0.0), Sign::on_surface);
  EXPECT_EQ(certet::sign_of_level(1), Sign::minus);
  EXPECT_EQ(certet::sign_of_level(std::numeric_limits<double>::quiet_NaN()), Sign::minus);
}

TEST(SignOf, Opposites) {
  EXPECT_TRUE(certet::opposite(Sign::plus, Sign::minus));
  EXPECT_TRUE(certet::opposite(Sign::minus, Sign::plus));
  EXPECT_FALSE(certet::opposite(Sign::plus, Sign::plus));
  EXPECT_FALSE(certet::opposite(Sign::on_surface, Sign::minus));
  EXPECT_FALSE(certet::opposite(Sign::plus, Sign::on_surface));
}

TEST(Pattern, IndexAndSignsAreInverse) {
  for (int i = 0; i < certet::pattern_count; ++i)
    EXPECT_EQ(certet::pattern_index(certet::pattern_signs(i)), i);
}

TEST(Stencil, CutsGoFromPlusToMinus) {
  for (int i = 0; i < certet::pattern_count; ++i) {
    const certet::CornerSigns signs = certet::pattern_signs(i);
    for (const certet::UnstructuredTet& tet : certet::unstructured_tets(signs))
      for (const certet::StencilVertex v : tet) {
        if (v.is_cut()) {
          EXPECT_EQ(signs[v.a], Sign::plus);
          EXPECT_EQ(signs[v.b], Sign::minus);
        } else {
          EXPECT_NE(signs[v.a], Sign::minus);
        }
      }
  }
}

TEST(StructuredTet, RightHandedCasesHaveAPositiveDeterminant) {
  for (int c = 0; c < certet::case_count; ++c) {
    const auto orientation = static_cast<certet::StructuredTetCase>(c);
    const auto v = certet::structured_tet({{0, 0, 0}, orientation}).vertices;
    const Coord3 a = v[1] - v[0], b = v[2] - v[0], d = v[3] - v[0];
    const int determinant = a.x * (b.y * d.z - b.z * d.y) - a.y * (b.x * d.z - b.z * d.x) +
                            a.z * (b.x * d.y - b.y * d.x);
    EXPECT_EQ(determinant, certet::right_handed(orientation) ? 4 : -4) << certet::case_names[static_cast<std::size_t>(c)];
  }
}

TEST(StructuredTet, RefusesAnAnchorOutOfRange) {
  constexpr std::int32_t limit = certet::anchor_limit;
  EXPECT_NO_THROW(certet::structured_tet({{limit, -limit, limit}, {}}));
  for (const Coord3 anchor : {Coord3{limit + 1, 0, 0}, Coord3{0, -limit - 1, 0},
                              Coord3{0, 0, std::numeric_limits<std::int32_t>::min()}})
    try {
      static_cast<void>(certet::structured_tet({anchor, {}}));
      FAIL() << "nothing was thrown";
    } catch (const certet::Error& error) {
      EXPECT_EQ(error.code(), certet::ErrorCode::too_large);
    }
}

TEST(StructuredTet, PositionsOfTheWholeRangeFit32Bits) {
  constexpr std::int64_t limit = certet::coordinate_limit;
  EXPECT_LE(limit * certet::steps, std::numeric_limits<std::int32_t>::max());
}

TEST(Warping, StaysByDefault) {
  EXPECT_FALSE(certet::Warping{}.moves());
  EXPECT_TRUE((certet::Warping{0, 0}).moves());
}

TEST(Thresholds, InSteps) {
  EXPECT_EQ(certet::angle_thresholds.in_steps(0), 73 * 256);
  EXPECT_EQ(certet::angle_thresholds.in_steps(6), 102 * 256);
  EXPECT_EQ(certet::no_warp_thresholds.in_steps(13), 0);
}

TEST(Frame, ALongEdgeHasTheSize) {
  certet::Frame frame;
  frame.origin = {1, 2, 3};
  frame.size = 0.5;
  EXPECT_EQ(frame.world({0, 0, 0}), (certet::Point3{1, 2, 3}));
  EXPECT_EQ(frame.world({2 * certet::steps, 0, 0}), (certet::Point3{1.5, 2, 3}));
  frame.axes = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
  EXPECT_EQ(frame.world({2 * certet::steps, 0, 0}), (certet::Point3{1, 2.5, 3}));
}

}  // namespace
