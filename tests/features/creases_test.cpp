/// \file
/// Sharp edges of surfaces: which there are, and whether a surface was drawn.

#include <gtest/gtest.h>

#include <set>

#include "certet/error.hpp"
#include "certet/features.hpp"
#include "certet/shape.hpp"
#include "parts.hpp"

namespace {

using certet::Coord3;
using certet::Features;

std::vector<certet::TriangleCorners> triangles_of(const certet::TriangleSurface& surface,
                                                  double size = 0.1) {
  return certet::surface_domain(surface, {size, 2})->triangles();
}

std::size_t patches_of(const Features& features) {
  return std::set(features.patches.begin(), features.patches.end()).size();
}

TEST(Creases, ABoxHasTwelveEdgesAndEightCorners) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 8; ++trial) {
    parts::Part part = parts::box(1, 1.3, 0.7);
    if (trial > 0) part = parts::placed(std::move(part), random);
    const Features found = features_of(triangles_of(part.surface), 40);
    EXPECT_EQ(found.edges.size(), 12U);
    EXPECT_EQ(found.corners.size(), 8U);
    EXPECT_EQ(patches_of(found), 6U);
    for (const certet::FeatureEdge& edge : found.edges) EXPECT_NE(edge.left, edge.right);
  }
}

TEST(Creases, CirclesHaveNoCorners) {
  const Features found = features_of(triangles_of(parts::cylinder(1, 2, 60).surface), 40);
  EXPECT_EQ(found.edges.size(), 120U);
  EXPECT_EQ(found.corners.size(), 0U);
  EXPECT_EQ(patches_of(found), 3U);
}

TEST(Creases, TheAngleDecides) {
  const auto triangles = triangles_of(parts::cylinder(1, 2, 8).surface);  // 45 degrees
  EXPECT_EQ(features_of(triangles, 44).edges.size(), 24U);
  EXPECT_EQ(features_of(triangles, 46).edges.size(), 16U);
  EXPECT_EQ(features_of(triangles, 91).edges.size(), 0U);
  for (const double angle : {0.0, -1.0, 180.0}) EXPECT_THROW(features_of(triangles, angle), certet::Error);
}

/// What a triangle's normal is where rounding has it.
TEST(Creases, ThinTrianglesAreNoEdges) {
  certet::TriangleSurface surface = parts::box(1, 1, 1).surface;
  // Beside an edge of each triangle of the upper face another, some steps high.
  const auto triangles = triangles_of(surface);
  std::vector<certet::TriangleCorners> with;
  for (const certet::TriangleCorners& t : triangles) {
    const auto between = [](std::int32_t a, std::int32_t b, std::int32_t c) {
      const std::int32_t middle = a / 2 + b / 2;
      return middle + (c - middle) / 50'000;
    };
    const Coord3 beside{between(t[0].x, t[1].x, t[2].x), between(t[0].y, t[1].y, t[2].y), t[0].z};
    if (t[0].z != t[1].z || t[1].z != t[2].z || t[0].z < 0) {
      with.push_back(t);
      continue;
    }
    with.push_back({t[0], t[1], beside});
    with.push_back({t[1], t[2], beside});
    with.push_back({t[2], t[0], beside});
  }
  EXPECT_EQ(features_of(with, 40).edges.size(), 12U);
}

TEST(Creases, ShapesHaveTheirs) {
  const certet::ShapeDomain box("box:1,2,3", {}, 0.1, 2), cylinder("cylinder:1,2", {}, 0.1, 2),
      ball("sphere:1", {}, 0.1, 2);
  EXPECT_EQ(features_of(box.facets(), 40).edges.size(), 12U);
  const Features circles = features_of(cylinder.facets(), 40);
  EXPECT_EQ(circles.corners.size(), 0U);
  EXPECT_EQ(patches_of(circles), 3U);
  for (const certet::FeatureEdge& edge : circles.edges)
    EXPECT_NEAR(std::hypot(edge.from.x, edge.from.y) / certet::steps, 20, 2.0 / certet::steps);
  EXPECT_TRUE(ball.facets().empty());
}

/// Of two boxes that overlap, the edges of each that are in the other are none of their union.
TEST(Creases, EdgesWithinTheSolidAreNone) {
  parts::Part one = parts::box(1, 1, 1);
  const parts::Part small = parts::box(0.5, 0.4, 0.3);
  const auto first = static_cast<std::uint32_t>(one.surface.points.size());
  for (const auto& [x, y, z] : small.surface.points)
    one.surface.points.push_back({x + 0.2, y + 0.3, z + 0.4});
  for (const auto& [a, b, c] : small.surface.triangles)
    one.surface.triangles.push_back({a + first, b + first, c + first});
  const auto domain = certet::surface_domain(one.surface, {0.1, 2});
  EXPECT_EQ(features_of(domain->facets(), 40).edges.size(), 24U);
  const Features found = features_of(*domain, 40);
  EXPECT_EQ(found.edges.size(), 12U);
  EXPECT_EQ(found.corners.size(), 8U);
}

TEST(Creases, WhatWasDrawnIsToldFromScans) {
  std::mt19937_64 random(11);
  using namespace parts;
  for (const Part& part : {box(1, 2, 3), cylinder(1, 2, 24), cylinder(1, 2, 200), angle_beam(3, 2),
                           star(2, 1, 1), rounded_block(0.5, 2, 1, 24)}) {
    EXPECT_TRUE(creases_of(triangles_of(part.surface)).are_drawn());
    // The same part as a scanner sees it.
    EXPECT_FALSE(creases_of(triangles_of(rough(part.surface, 4, 0.02, random))).are_drawn());
  }
  EXPECT_FALSE(creases_of(triangles_of(ball(3))).are_drawn());
  EXPECT_FALSE(creases_of(triangles_of(rough(ball(4), 0, 0.01, random))).are_drawn());
  EXPECT_FALSE(creases_of(triangles_of(rough(ball(4), 0, 0.03, random))).are_drawn());
}

TEST(Creases, ADecisionSaysWhy) {
  const auto box = certet::surface_domain(parts::box(1, 1, 1).surface, {0.1, 2});
  const auto ball = certet::surface_domain(parts::ball(3), {0.1, 2});
  const certet::ShapeDomain torus("torus:1,0.4", {}, 0.1, 2);
  using certet::Method;
  const auto decide = [](bool automatic, std::optional<double> angle, const certet::PlacedDomain& domain,
                         Method method = Method::embedded) {
    return certet::decide_features({automatic, angle}, domain, method);
  };
  EXPECT_EQ(decide(true, {}, *box).angle, 40);
  EXPECT_FALSE(decide(true, {}, *ball).angle);
  EXPECT_FALSE(decide(true, {}, torus).angle);
  EXPECT_FALSE(decide(false, {}, *box).angle);
  EXPECT_FALSE(decide(true, {}, *box, Method::midpoint).angle);
  EXPECT_EQ(decide(false, 15, *ball).angle, 15);
  EXPECT_EQ(decide(false, 15, torus).angle, 15);
  EXPECT_THROW(decide(false, 15, *box, Method::midpoint), certet::Error);
  for (const bool automatic : {true, false}) EXPECT_FALSE(decide(automatic, {}, *ball).why.empty());
}

}  // namespace
