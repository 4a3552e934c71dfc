/// \file
/// Tetrahedra that overlap are found, and those that touch are not taken for such.

#include "overlap.hpp"

#include <gtest/gtest.h>

namespace {

using certet::Coord3;

constexpr std::int32_t one = certet::steps;
constexpr exact::Tet corner{{{0, 0, 0}, {one, 0, 0}, {0, one, 0}, {0, 0, one}}};

exact::Tet moved(exact::Tet tet, Coord3 by) {
  for (Coord3& v : tet) v = v + by;
  return tet;
}

std::uint64_t found(const exact::Tet& a, const exact::Tet& b) {
  return thin::overlaps({a, b}).found;
}

TEST(Overlap, OfOneStepIsFound) {
  EXPECT_EQ(found(corner, corner), 1U);
  EXPECT_EQ(found(corner, moved(corner, {one - 1, 0, 0})), 1U);
  EXPECT_EQ(found(corner, moved(corner, {one, 0, 0})), 0U);
  EXPECT_EQ(found(corner, moved(corner, {one / 3, one / 3, one / 3})), 1U);
  EXPECT_EQ(found(corner, moved(corner, {one / 3, one / 3, one / 3 + 1})), 0U);
}

/// On one side of a face that they share, or on both.
TEST(Overlap, AcrossAFaceIsNone) {
  exact::Tet other = corner;
  other[3] = {0, 0, -one};
  EXPECT_EQ(found(corner, other), 0U);
  other[3] = {one, one, one};
  EXPECT_EQ(found(corner, other), 1U);
}

/// Where no face separates them, planes along an edge of each do.
TEST(Overlap, OfEdgesThatCrossIsTold) {
  const exact::Tet below{{{-one, 0, 0}, {one, 0, 0}, {0, one, -one}, {0, -one, -one}}};
  const exact::Tet above{{{0, -one, 0}, {0, one, 0}, {one, 0, one}, {-one, 0, one}}};
  EXPECT_EQ(found(below, above), 0U);
  EXPECT_EQ(found(below, moved(above, {0, 0, 1})), 0U);
  EXPECT_EQ(found(below, moved(above, {0, 0, -1})), 1U);
}

TEST(Overlap, AmongManyIsCounted) {
  std::vector<exact::Tet> row;
  for (std::int32_t n = 0; n < 10; ++n) row.push_back(moved(corner, {n * one, 0, 0}));
  EXPECT_EQ(thin::overlaps(row).found, 0U);
  for (std::int32_t n = 0; n < 10; ++n) row.push_back(moved(corner, {n * one + one / 2, 0, 0}));
  EXPECT_EQ(thin::overlaps(row).found, 19U);
}

}  // namespace
