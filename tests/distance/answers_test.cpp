// Distances of points from shapes that only answer what is inside, against what they are.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "../seed.hpp"
#include "certet/bounded_function.hpp"
#include "certet/materials_domain.hpp"
#include "shapes.hpp"

namespace certet {
namespace {

using namespace shapes;

constexpr double size = 0.1, step = size / (2.0 * steps);

using Truth = std::function<double(const Point3&)>;

std::vector<Point3> random_points(std::uint64_t seed, double reach) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::vector<Point3> points(3000);
  for (Point3& point : points)
    for (double& c : point) c = coordinate(random);
  return points;
}

/// None is less than the truth by more than two steps; the greatest part by which one is more.
double excess(const PlacedDomain& domain, const Truth& truth, const std::vector<Point3>& points,
              double beyond, bool interfaces = false) {
  Context context;
  const std::vector<double> found = distances_from(domain, interfaces, points, context);
  double greatest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = std::abs(truth(points[i]));
    EXPECT_GE(found[i], distance - 2 * step) << points[i][0] << ' ' << points[i][1] << ' ' << points[i][2];
    if (distance <= beyond)
      greatest = std::max(greatest, (found[i] - distance - 2 * step) / distance);
  }
  return greatest;
}

double from_sphere(const Point3& p) { return length(p) - 1; }
double from_torus(const Point3& p) {
  return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4;
}
double from_box(const Point3& p) {
  const std::array<double, 3> q{std::abs(p[0]) - 0.5, std::abs(p[1]) - 0.4, std::abs(p[2]) - 0.35};
  const double most = std::max({q[0], q[1], q[2]});
  return std::hypot(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0)) +
         std::min(most, 0.0);
}

TEST(Answers, TellDistancesFromSmoothShapesToAHundredth) {
  const std::vector<Point3> points = random_points(test_seed(), 1.4);
  const double sphere = excess(shape("sphere:1", size), from_sphere, points, 0.1);
  const double torus = excess(shape("torus:1,0.4", size), from_torus, points, 0.1);
  std::printf("within a long edge: %.4f of a sphere, %.4f of a torus\n", sphere, torus);
  EXPECT_LT(sphere, 0.01);
  EXPECT_LT(torus, 0.01);
}

/// At a corner a nearest point may hide between probes.
TEST(Answers, TellDistancesFromABox) {
  const double box = excess(shape("box:1,0.8,0.7", size), from_box, random_points(test_seed(), 0.6), 0.1);
  std::printf("within a long edge: %.4f of a box\n", box);
  EXPECT_LT(box, 0.08);
}

/// Where no probe finds anything, the nearest known point of the surface is gone on from.
TEST(Answers, TellDistancesFromFarAway) {
  const std::vector<Point3> points{{0, 0, 0}, {3, 0, 0}, {-2, 2.5, 1}, {0.1, -0.2, 7}};
  EXPECT_LT(excess(shape("sphere:1", size), from_sphere, points, 100), 0.02);
}

/// Between materials, too: a ball in a ball, or its wall alone where materials are not told apart.
TEST(Answers, TellWhereMaterialsMeet) {
  const std::vector<NamedSolid> solids{{"outer", shape_solid("sphere:1")},
                                       {"inner", shape_solid("sphere:0.5")}};
  const auto domain = materials_domain(solids, {size, 2});
  const auto both = [](const Point3& p) {
    return std::min(std::abs(length(p) - 1), std::abs(length(p) - 0.5));
  };
  const std::vector<Point3> points = random_points(test_seed(), 1.0);
  EXPECT_LT(excess(*domain, both, points, 0.1, true), 0.01);
  EXPECT_LT(excess(*domain, from_sphere, points, 0.1, false), 0.01);
}

/// A box that cuts a shape off is part of what is meshed.
TEST(Answers, TellWhereAShapeIsCutOff) {
  const BoundedFunction slab([](Point3 p) { return std::abs(p[2]) - 0.3; }, {{-1, -1, -1}, {1, 1, 1}},
                             size);
  Context context;
  const std::vector<Point3> points{{0.95, 0, 0}, {0, 0, 0.25}};
  const std::vector<double> found = distances_from(slab, false, points, context);
  EXPECT_NEAR(found[0], 0.05, 3 * step);
  EXPECT_NEAR(found[1], 0.05, 3 * step);
}

}  // namespace
}  // namespace certet
