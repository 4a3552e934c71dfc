/// \file
/// Domains on other lattices than their own: what they answer there, point by point.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/moved_domain.hpp"
#include "certet/placed_quality.hpp"
#include "extents.hpp"
#include "lattice_rows.hpp"
#include "seed.hpp"
#include "solids.hpp"

namespace certet {
namespace {

using Axes = std::array<std::array<double, 3>, 3>;

Axes about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

/// Half turns and quarter turns go from points of the lattice to points.
const std::vector<Axes>& all_axes() {
  static const std::vector<Axes> all{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
                                     {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}},
                                     {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
                                     about_z(0.3)};
  return all;
}

const Bounds box{{-1, -0.5, -0.25}, {0.75, 0.5, 1}};

double beyond_box(const Point3& p) { return beyond(box, p); }

/// Points of which the domain says another thing than the box, or another one in rows; those
/// within `near` of its faces do not count.
int differences(const PlacedDomain& domain, double near) {
  int count = 0;
  for_each_sign(domain, domain.lattice(), [&](Coord3 position, Sign in_row, Sign alone) {
    const double far = beyond_box(domain.frame().world(position));
    count += in_row != alone;
    if (std::fabs(far) > near) count += alone != (far < 0 ? Sign::plus : Sign::minus);
  });
  return count;
}

PlacedLattice lattice_of(const Axes& axes, const Point3& origin, double size) {
  const Frame frame{origin, axes, size};
  return {lattice_holding(frame, box, 2), frame};
}

TEST(MovedDomain, ASurfaceOnTurnedLattices) {
  std::mt19937_64 random(test_seed());
  const Solid solid = solids::block(box.low, box.high);
  int decided = 0;
  for (const Axes& axes : all_axes()) {
    const auto domain = placed_on(solid, lattice_of(axes, {0.1, -0.2, 0.3}, 0.07));
    EXPECT_EQ(differences(*domain, 1e-5), 0);
    const PlacedLattice elsewhere = lattice_of(axes, {0.15, -0.2, 0.3}, 0.07);
    // A lattice that lies a little beside would not go unnoticed.
    EXPECT_GT(differences(*moved_domain(solid.on({lattice_holding({.size = 0.07}, box, 1),
                                                  {.size = 0.07}}),
                                        {elsewhere.lattice, {{}, axes, 0.07}}),
                          1e-5) +
                  differences(*placed_on(solids::block({-1, -0.5, -0.25}, {0.75, 0.57, 1}),
                                         elsewhere),
                              1e-5),
              0);
    EXPECT_EQ(extents::first_contradiction(random, *domain, domain->lattice(), 200, decided), "");
  }
  EXPECT_GT(decided, 0);
}

/// What touches the lattice's points does so after a quarter turn, too.
TEST(MovedDomain, QuarterTurnsAreExact) {
  const Solid solid = solids::block({-1, -1, -1}, {1, 1, 1});
  for (const Axes& axes : all_axes()) {
    if (axes == all_axes().back()) continue;
    const Frame frame{{0, 0, 0}, axes, 0.25};
    const auto domain = placed_on(solid, {lattice_holding(frame, solid.bounds, 1), frame});
    int touched = 0;
    for_each_sign(*domain, domain->lattice(), [&](Coord3 position, Sign in_row, Sign alone) {
      const Point3 p = frame.world(position);
      const double far = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}) - 1;
      touched += far == 0;
      ASSERT_EQ(in_row, sign_of_level(far));
      ASSERT_EQ(alone, in_row);
    });
    EXPECT_EQ(touched, 9 * 9 * 9 - 7 * 7 * 7);
  }
}

TEST(MovedDomain, CutsAreWhereTheSurfaceIs) {
  for (const Axes& axes : all_axes()) {
    const auto domain =
        placed_on(solids::block(box.low, box.high), lattice_of(axes, {0.1, -0.2, 0.3}, 0.1));
    const Mesh found = mesh(*domain, Method::midpoint);
    EXPECT_GT(found.points.size(), 100u);
    EXPECT_NEAR(quality(mesh(*domain)).world.volume, 1.75 * 1.25, 0.03);
  }
}

/// A border is where the shape is cut off, seen from any lattice.
TEST(MovedDomain, BordersMoveAlong) {
  const Solid solid = shape_solid("sphere:1", box);
  for (const Axes& axes : all_axes()) {
    const auto domain = placed_on(solid, lattice_of(axes, {0.1, -0.2, 0.3}, 0.1));
    ASSERT_EQ(domain->border().size(), 1u);
    const Mesh found = mesh(*domain);
    int at_face = 0;
    for (const Coord3 point : found.points) {
      const Point3 p = found.frame.world(point);
      const bool near = std::fabs(beyond_box(p)) < 1e-4 * 0.1 &&
                        std::hypot(p[0], p[1], p[2]) < 0.99;
      if (domain->border()[0].is_at_face(point)) ++at_face;
      else EXPECT_FALSE(near) << p[0] << ' ' << p[1] << ' ' << p[2];
    }
    EXPECT_GT(at_face, 50);
  }
}

}  // namespace
}  // namespace certet
