/// \file
/// Named shapes: distances that are distances, volumes, and what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "certet/error.hpp"
#include "certet/shape.hpp"
#include "certet/stuffing.hpp"
#include "distances.hpp"
#include "domains.hpp"
#include "extents.hpp"

namespace {

using certet::Point3;
using certet::ShapeDomain;
using std::numbers::pi;

const certet::Bounds corner{{-9, 0, 0}, {0, 9, 9}};

certet::Mesh mesh(const certet::Domain& domain, const ShapeDomain& shape) {
  certet::Context context;
  return certet::stuff(domain, shape.lattice(), shape.frame(), {}, context);
}

/// In world units.
double volume(const ShapeDomain& shape) {
  const certet::Mesh all = mesh(shape, shape);
  double sum = 0;
  const auto add = [&](const auto& tets) {
    for (const auto& tet : tets) {
      std::array<Point3, 4> p;
      for (std::size_t v = 0; v < 4; ++v) p[v] = shape.frame().world(all.points[tet[v]]);
      std::array<Point3, 3> e;
      for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t a = 0; a < 3; ++a) e[v][a] = p[v + 1][a] - p[0][a];
      sum += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
              e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
              e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6;
    }
  };
  std::visit(add, all.tets);
  return sum;
}

TEST(Shape, Volumes) {
  const auto expect = [](const char* shape, double size, double exact) {
    EXPECT_NEAR(volume(ShapeDomain(shape, {}, size, 2)) / exact, 1, 0.01) << shape;
  };
  expect("sphere:1", 0.05, 4 * pi / 3);
  expect("torus:1,0.4", 0.04, 2 * pi * pi * 0.16);
  expect("box:1,2,3", 0.05, 6);
  expect("cylinder:0.5,2", 0.04, pi / 2);
  expect("gyroid:1,0.1", 0.02, 8 * 0.35186);  // the share of the space, by summation
  expect("gyroid:1,0.1,1", 0.02, 0.35186);
  // Three bars through a cell, less what they share at its corners.
  const auto struts = [](double r) { return 3 * pi * r * r - 8 * std::numbers::sqrt2 * r * r * r; };
  expect("struts:1,0.2", 0.04, 8 * struts(0.2));
  expect("struts:1,0.3,3", 0.05, 27 * struts(0.3));
}

TEST(Shape, BoundsCutItOff) {
  EXPECT_NEAR(volume(ShapeDomain("sphere:1", corner, 0.025, 2)) / (pi / 6), 1, 0.02);
  const ShapeDomain part("sphere:1", corner, 0, 2);
  EXPECT_EQ(part.bounds().low, (Point3{-1, 0, 0}));
  EXPECT_EQ(part.bounds().high, (Point3{0, 1, 1}));
  const ShapeDomain gyroid("gyroid:1,0.1", certet::Bounds{{0, 0, 0}, {1, 2, 3}}, 0, 2);
  EXPECT_EQ(gyroid.bounds().high, (Point3{1, 2, 3}));
}

TEST(Shape, ExtentAgreesWithRows) {
  std::mt19937_64 random(test_seed());
  for (const char* shape : {"sphere:1", "torus:1,0.4", "box:1,2,1.5", "cylinder:0.8,2",
                            "gyroid:4,0.5,3", "primitive:3,0.5,3", "diamond:3,0.3,3", "iwp:4,0.4,3",
                            "neovius:4,0.3,3", "struts:1,0.2,3"})
    for (const auto& bounds : {std::optional<certet::Bounds>{}, std::optional(corner)}) {
      if (bounds && ShapeDomain(shape, {}, 0, 2).room()) continue;  // it would fill all of them
      const ShapeDomain domain(shape, bounds, 0.03, 3);
      int decided = 0;
      EXPECT_EQ(extents::first_contradiction(random, domain, domain.lattice(), 300, decided), "")
          << shape;
      EXPECT_GT(decided, 20) << shape;
    }
}

TEST(Shape, SkippedBlocksDoNotChangeTheMesh) {
  for (const char* name : {"torus:1,0.4", "gyroid:1,0.2"}) {
    const ShapeDomain shape(name, {}, 0.05, 2);
    const certet::Mesh one = mesh(shape, shape);
    const certet::Mesh two = mesh(domains::SignsAlone(shape), shape);
    EXPECT_TRUE(std::ranges::equal(one.points, two.points)) << name;
  }
}

/// By how much values differ at most, over the distance of the points.
template <class Solid>
double steepest(const Solid& solid) {
  std::mt19937_64 random(test_seed());
  std::uniform_real_distribution<double> real(-2, 2), little(-0.03, 0.03);
  double most = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Point3 p{real(random), real(random), real(random)};
    const Point3 q{p[0] + little(random), p[1] + little(random), p[2] + little(random)};
    const double apart = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    most = std::max(most, std::abs(solid(p) - solid(q)) / apart);
  }
  return most;
}

TEST(Shape, FunctionsAreNoSteeperThanDistances) {
  using namespace certet::shape;
  const double limit = 1 + 1e-9;
  EXPECT_LE(steepest(Sphere{1}), limit);
  EXPECT_LE(steepest(Torus{1, 0.4}), limit);
  EXPECT_LE(steepest(Box{{{-1, -0.5, -1}, {1, 0.7, 0.3}}}), limit);
  EXPECT_LE(steepest(Cylinder{1, 0.6}), limit);
  EXPECT_LE(steepest(Gyroid{1.1, 0.1}), limit);
  EXPECT_GT(steepest(Gyroid{1.1, 0.1}), 0.9);
  EXPECT_LE(steepest(Primitive{1.1, 0.1}), limit);
  EXPECT_GT(steepest(Primitive{1.1, 0.1}), 0.9);
  EXPECT_LE(steepest(Diamond{1.1, 0.1}), limit);
  EXPECT_GT(steepest(Diamond{1.1, 0.1}), 0.9);
  EXPECT_LE(steepest(Iwp{1.1, 0.1}), limit);
  EXPECT_GT(steepest(Iwp{1.1, 0.1}), 0.8);
  EXPECT_LE(steepest(Neovius{1.1, 0.1}), limit);
  EXPECT_GT(steepest(Neovius{1.1, 0.1}), 0.8);
  EXPECT_LE(steepest(Struts{1.1, 0.2}), limit);
  const auto too_steep = [](const Point3& p) { return 1.1 * Torus{1, 0.4}(p); };
  EXPECT_GT(steepest(too_steep), limit);
}

TEST(Shape, WhatIsRefused) {
  const auto refused = [](const std::string& shape, const std::string& word) {
    try {
      const ShapeDomain domain(shape, {}, 0, 2);
      ADD_FAILURE() << shape;
    } catch (const certet::Error& error) {
      EXPECT_EQ(error.code(), certet::ErrorCode::bad_option);
      EXPECT_NE(std::string(error.what()).find(shape), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused("", "does not exist");
  refused("cone:1", "does not exist");
  refused("sphere", "sphere:R");
  refused("sphere:", "positive");
  refused("sphere:0", "positive");
  refused("sphere:-1", "positive");
  refused("sphere:nan", "positive");
  refused("sphere:1,", "positive");
  refused("sphere:1,2", "2 numbers");
  refused("torus:1", "torus:R,r");
  refused("torus:1,1", "ring");
  refused("box:1,2", "box:a,b,c");
  refused("cylinder:1,2m", "'2m'");
  refused("gyroid:1,0.3", "gap");
  refused("gyroid:1,0.1,2,3", "4 numbers");
  refused("primitive:1,0.6", "gap");
  refused("diamond:1,0.27", "gap");
  refused("iwp:1,0.2", "gap");
  refused("neovius:1,0.6", "gap");
  refused("struts:1,0.71", "gap");
  refused("struts:1", "struts:CELL,RADIUS[,SIDE]");
  refused("lattice:1,0.1", "neovius, struts");
  EXPECT_THROW(ShapeDomain("sphere:1", certet::Bounds{{2, 2, 2}, {3, 3, 3}}, 0, 2),
               certet::Error);
}

}  // namespace
