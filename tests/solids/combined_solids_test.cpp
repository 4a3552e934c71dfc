/// \file
/// Solids made of two others: against the definition, and their volumes.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/combined_solids.hpp"
#include "certet/error.hpp"
#include "certet/placed_quality.hpp"
#include "extents.hpp"
#include "seed.hpp"
#include "solids.hpp"

namespace certet {
namespace {

std::shared_ptr<const PlacedDomain> placed(const Solid& solid, double size) {
  return solid.on(lattice_around(solid.bounds, size, 2));
}

double volume(const Solid& solid) {
  return quality(mesh(*placed(solid, 0.05))).world.volume;
}

const double quarter = std::numbers::pi / 6;  // of the volume of a ball of radius 1, an eighth

TEST(CombinedSolids, Volumes) {
  const Solid ball = solids::ball(1);
  const Solid corner = solids::block({0, 0, 0}, {2, 2, 2});
  const double ball_volume = 8 * quarter;
  EXPECT_NEAR(volume(ball & corner), quarter, 0.02 * quarter);
  EXPECT_NEAR(volume(ball - corner), ball_volume - quarter, 0.02 * ball_volume);
  EXPECT_NEAR(volume(corner - ball), 8 - quarter, 0.1);
  EXPECT_NEAR(volume(corner | ball), 8 + ball_volume - quarter, 0.1);
  EXPECT_NEAR(volume((ball | corner) - (ball & corner)), 8 + ball_volume - 2 * quarter, 0.15);
}

TEST(CombinedSolids, BoundsAreThoseOfTheResult) {
  const Solid a = solids::block({0, 0, 0}, {2, 2, 2}), b = solids::block({1, -1, 1}, {3, 1, 1.5});
  EXPECT_EQ((a & b).bounds.low, (Point3{1, 0, 1}));
  EXPECT_EQ((a & b).bounds.high, (Point3{2, 1, 1.5}));
  EXPECT_EQ((a | b).bounds.low, (Point3{0, -1, 0}));
  EXPECT_EQ((a - b).bounds.high, a.bounds.high);
  EXPECT_THROW(static_cast<void>(a & solids::block({2, 0, 0}, {3, 1, 1})), Error);
}

/// Two that share a wall leave no slit, and have nothing in common.
TEST(CombinedSolids, OfTwoWithACommonWall) {
  const Solid left = solids::block({-1, -1, -1}, {0, 1, 1});
  const Solid right = solids::block({0, -1, -1}, {1, 1, 1});
  EXPECT_NEAR(volume(left | right), 8, 0.05);
  EXPECT_NEAR(volume(left - right), 4, 0.05);
  const Mesh whole = mesh(*placed(left | right, 0.25));
  for (const Coord3 point : whole.points) {
    const Point3 p = whole.frame.world(point);
    if (p[0] == 0) continue;  // a slit would have its points beside the wall
    EXPECT_GT(std::fabs(p[0]), 0.01);
  }
}

TEST(CombinedSolids, SignsAreTheDefinitionsAndBlocksKeepTheirWord) {
  std::mt19937_64 random(test_seed());
  const Solid ball = solids::ball(1), box = solids::block({-0.5, -0.5, -2}, {0.75, 1, 2});
  const Solid both = ball & box, either = ball | box, without = ball - box;
  const PlacedLattice around = lattice_around(either.bounds, 0.05, 2);
  const auto a = ball.on(around), b = box.on(around);
  const auto in = [](const PlacedDomain& domain, Coord3 p) {
    Sign sign{};
    domain.at({&p, 1}, {&sign, 1});
    return sign;
  };
  for (const Solid* solid : {&both, &either, &without}) {
    const auto domain = solid->on(around);
    int seen = 0;
    for (int n = 0; n < 3000; ++n) {
      const auto at = [&](std::int32_t cells) {
        return between(random, -steps * cells, steps * cells);
      };
      const auto& cells = around.lattice.cells;
      const Coord3 p{at(cells[0]), at(cells[1]), at(cells[2])};
      const bool in_a = in(*a, p) == Sign::plus, in_b = in(*b, p) == Sign::plus;
      const bool expected = solid == &both     ? in_a && in_b
                            : solid == &either ? in_a || in_b
                                               : in_a && !in_b;
      ASSERT_EQ(in(*domain, p) == Sign::plus, expected);
      seen += expected;
    }
    EXPECT_GT(seen, 10);
    int decided = 0;
    for (int n = 0; n < 200; ++n)
      ASSERT_EQ(extents::contradiction(random, *domain, around.lattice, decided), "");
    EXPECT_GT(decided, 20);
  }
}

}  // namespace
}  // namespace certet
