/// \file
/// The small numbers that others build upon: frames, checksums, orientation.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "certet/checksum.hpp"
#include "certet/lattice/coord3.hpp"
#include "certet/frame.hpp"
#include "certet/lattice/orientation.hpp"
#include "certet/lattice/sign.hpp"
#include "certet/lattice/structured_tet.hpp"

namespace certet {
namespace {

TEST(Coordinates, AddSubtractAndScale) {
  EXPECT_EQ((Coord3{1, 2, 3} + Coord3{10, 20, 30}), (Coord3{11, 22, 33}));
  EXPECT_EQ((Coord3{1, 2, 3} - Coord3{10, 21, 32}), (Coord3{-9, -19, -29}));
  EXPECT_EQ((3 * Coord3{1, -2, 5}), (Coord3{3, -6, 15}));
  EXPECT_EQ(steps, 65536);
  // Any lattice point in use has a position of 32 bits.
  EXPECT_LE(std::int64_t{coordinate_limit} * steps, std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(coordinate_limit, 32000);
}

TEST(Coordinates, AnAnchorOutOfRangeIsRefused) {
  EXPECT_EQ(anchor_limit, 31992);
  for (const auto axis : {&Coord3::x, &Coord3::y, &Coord3::z})
    for (const std::int32_t sign : {-1, 1}) {
      Coord3 anchor{0, 0, 0};
      anchor.*axis = sign * anchor_limit;
      EXPECT_NO_THROW(structured_tet({anchor, StructuredTetCase::I1}));
      anchor.*axis += 2 * sign;
      EXPECT_THROW(structured_tet({anchor, StructuredTetCase::I1}), Error);
    }
}

TEST(Signs, AreOppositeOnlyAcrossTheSurface) {
  for (const Sign a : {Sign::minus, Sign::on_surface, Sign::plus})
    for (const Sign b : {Sign::minus, Sign::on_surface, Sign::plus}) {
      const int product = (static_cast<int>(a) - 1) * (static_cast<int>(b) - 1);
      EXPECT_EQ(opposite(a, b), product < 0);
    }
  EXPECT_EQ(sign_of_level(-1e-300), Sign::plus);
  EXPECT_EQ(sign_of_level(0), Sign::on_surface);
  EXPECT_EQ(sign_of_level(-0.0), Sign::on_surface);
  EXPECT_EQ(sign_of_level(1e-300), Sign::minus);
  EXPECT_EQ(sign_of_level(std::nan("")), Sign::minus);
}

/// Of vectors without zeros, so that each of the six products counts.
TEST(Orientation, IsTheDeterminant) {
  const Coord3 a{7, -11, 13};
  const Coord3 u{2, 3, 5}, v{-7, 11, 4}, w{13, -6, 9};
  // 2*(11*9+4*6) - 3*(-7*9-4*13) + 5*(7*6-11*13)
  EXPECT_EQ(six_volume(a, a + u, a + v, a + w), 246 + 345 - 505);
  EXPECT_EQ(six_volume(a, a + v, a + u, a + w), -86);
  EXPECT_EQ(six_volume(a, a + v, a + w, a + u), 86);
  EXPECT_EQ(six_volume({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}), 30);
  constexpr std::int32_t wide = (1 << 19) - 1;
  EXPECT_EQ(six_volume({0, 0, 0}, {wide, 0, 0}, {0, wide, 0}, {0, 0, wide}),
            std::int64_t{wide} * wide * wide);
}

using Narrow = std::vector<Tet<std::uint32_t>>;

std::uint64_t checksum(const std::vector<Coord3>& points, const Narrow& tets,
                       std::uint64_t first_point = 0, std::uint64_t first_tet = 0) {
  Checksum sum;
  sum.points(first_point, points);
  sum.tets(first_tet, std::span<const Tet<std::uint32_t>>(tets));
  return sum.value();
}

const std::vector<Coord3> some_points{{1, 2, 3}, {-4, 5, -6}, {7, 8, 9}, {10, 11, -12}};
const Narrow some_tets{{0, 1, 2, 3}, {3, 2, 1, 0}};

/// Files made by other versions carry checksums: the function must not change.
TEST(Checksums, AreWhatTheyHaveAlwaysBeen) {
  EXPECT_EQ(checksum({}, {}), 0U);
  EXPECT_EQ(checksum(some_points, some_tets), 0x58708be24724a7d7U);
}

TEST(Checksums, DependOnEveryBit) {
  const std::uint64_t whole = checksum(some_points, some_tets);
  for (std::size_t p = 0; p < some_points.size(); ++p)
    for (const auto axis : {&Coord3::x, &Coord3::y, &Coord3::z})
      for (int bit = 0; bit < 32; ++bit) {
        std::vector<Coord3> points = some_points;
        points[p].*axis = static_cast<std::int32_t>(static_cast<std::uint32_t>(points[p].*axis) ^
                                                    std::uint32_t{1} << bit);
        EXPECT_NE(checksum(points, some_tets), whole);
      }
  for (std::size_t corner = 0; corner < 4; ++corner)
    for (int bit = 0; bit < 32; ++bit) {
      Narrow tets = some_tets;
      tets[1][corner] ^= std::uint32_t{1} << bit;
      EXPECT_NE(checksum(some_points, tets), whole);
    }
  EXPECT_NE(checksum(some_points, {some_tets[1], some_tets[0]}), whole);
  EXPECT_NE(checksum(some_points, some_tets, 1), whole);
  EXPECT_NE(checksum(some_points, some_tets, 0, 1), whole);
}

/// The same of points as files have them.
TEST(Checksums, DependOnEveryBitOfAFilesPoints) {
  const auto sum_of = [](const std::vector<Point3>& points) {
    Checksum sum;
    sum.points(0, points);
    return sum.value();
  };
  const std::vector<Point3> given{{0.1, -2.5, 3e10}, {4, 5e-7, -6}};
  EXPECT_EQ(sum_of(given), 6563412520085952888U);
  for (std::size_t p = 0; p < given.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int bit = 0; bit < 64; ++bit) {
        std::vector<Point3> points = given;
        points[p][axis] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(points[p][axis]) ^
                                                std::uint64_t{1} << bit);
        EXPECT_NE(sum_of(points), sum_of(given));
      }
  EXPECT_NE(sum_of({given[1], given[0]}), sum_of(given));
  for (const Point3& turned : {Point3{-2.5, 0.1, 3e10}, {3e10, -2.5, 0.1}, {0.1, 3e10, -2.5}})
    EXPECT_NE(sum_of({turned, given[1]}), sum_of(given));
}

TEST(Checksums, AddUpInAnyOrderAndWidth) {
  const std::uint64_t whole = checksum(some_points, some_tets);
  const std::span<const Coord3> points(some_points);
  const std::vector<Tet<std::uint64_t>> wide{{0, 1, 2, 3}, {3, 2, 1, 0}};
  Checksum late, early;
  late.tets(1, std::span(wide).subspan(1));
  late.points(3, points.subspan(3));
  early.points(0, points.subspan(0, 3));
  early.tets(0, std::span(wide).subspan(0, 1));
  EXPECT_EQ((late += early).value(), whole);
}

/// A turned frame whose origin is `distance` long edges away along each axis.
Frame far_frame(double distance) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  Frame frame{.axes = {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, .size = 0.37};
  frame.origin.fill(distance * frame.size);
  return frame;
}

TEST(Frame, IsASimilarity) {
  const Frame frame{.origin = {1, 20, 300},
                    .axes = {{{2, 3, 5}, {7, 11, 13}, {17, 19, 23}}},  // each entry is told apart
                    .size = 4};
  const Point3 world = frame.world({steps, 10 * steps, 100 * steps});
  EXPECT_EQ(world, (Point3{1 + 2 * (2 + 30 + 500), 20 + 2 * (7 + 110 + 1300),
                           300 + 2 * (17 + 190 + 2300)}));
  EXPECT_EQ(Frame{}.world({2 * steps, 4 * steps, -6 * steps}), (Point3{1, 2, -3}));
}

TEST(Frame, RoundingGrowsWithTheFarthestAxis) {
  EXPECT_EQ(Frame{}.rounding(2), std::ldexp(16.0, -53));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Frame frame{.size = 0.5};
      frame.origin[axis] = sign * 1e6;
      EXPECT_EQ(frame.rounding(100), std::ldexp(2e6 + 800, -53));
    }
}

TEST(Frame, TellsRotationsFromOthers) {
  EXPECT_TRUE(Frame{}.is_rotation(0));
  EXPECT_TRUE(far_frame(1).is_rotation(1e-15));
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      Frame bent;
      bent.axes[row][column] += 0.01;
      EXPECT_FALSE(bent.is_rotation(1e-3));
      bent.axes[row][column] = std::nan("");
      EXPECT_FALSE(bent.is_rotation(1e-3));
    }
  // A dot product of exactly the tolerance is let through, on either side.
  for (const double shear : {-0.25, 0.25}) {
    Frame frame;
    frame.axes = {{{1, shear, 0}, {0, std::sqrt(1 - shear * shear), 0}, {0, 0, 1}}};
    EXPECT_TRUE(frame.is_rotation(0.25));
    EXPECT_FALSE(frame.is_rotation(0.249));
  }
}

}  // namespace
}  // namespace certet
