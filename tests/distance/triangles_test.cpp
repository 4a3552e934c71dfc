// The nearest of triangles against all of them; surfaces, whose distances are exact.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../seed.hpp"
#include "../surface/surfaces.hpp"
#include "certet/surface.hpp"
#include "mesh/distance/triangle_tree.hpp"
#include "shapes.hpp"

namespace certet {
namespace {

using namespace shapes;
using surfaces::box;
using distance::Corners;
using distance::Triangle;
using distance::TriangleTree;

Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// By very many points of the triangle.
double plain_distance(const Corners& t, const Point3& p) {
  constexpr int parts = 60;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) {
      Point3 q;
      for (std::size_t a = 0; a < 3; ++a)
        q[a] = t.a[a] + (t.b[a] - t.a[a]) * i / parts + (t.c[a] - t.a[a]) * j / parts;
      least = std::min(least, length(minus(p, q)));
    }
  return least;
}

class Triangles : public testing::Test {
 protected:
  Point3 point(double reach = 1) {
    std::uniform_real_distribution<double> c(-reach, reach);
    return {c(random), c(random), c(random)};
  }
  std::mt19937_64 random{test_seed()};
};

TEST_F(Triangles, HaveANearestPoint) {
  for (int trial = 0; trial < 300; ++trial) {
    Corners t{point(), point(), point()};
    if (trial % 4 == 1) t.b = t.a;                  // an edge
    if (trial % 4 == 2) t.b = t.c = t.a;            // a point
    if (trial % 4 == 3) t.c = minus(t.b, minus(t.a, t.b));  // in a line
    const Point3 p = point(2);
    const double found = length(minus(p, distance::nearest_on(t, p)));
    const double plain = plain_distance(t, p);
    EXPECT_LE(found, plain + 1e-12);
    EXPECT_GE(found, plain - 0.03);
  }
}

TEST_F(Triangles, AreFoundByTheTree) {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < 500; ++t) {
    const Point3 middle = point();
    for (int corner = 0; corner < 3; ++corner) {
      const Point3 aside = point(0.1);
      points.push_back({middle[0] + aside[0], middle[1] + aside[1], middle[2] + aside[2]});
    }
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const TriangleTree tree(points, triangles);
  for (int trial = 0; trial < 1000; ++trial) {
    const Point3 p = point(2);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < 500; ++t)
      least = std::min(least, length(minus(p, distance::nearest_on(tree.corners(t), p))));
    EXPECT_EQ(std::sqrt(tree.nearest(p).square), least);
  }
}

/// A corner that a lattice cannot have is cut off; the shape's distance says by how much.
TEST(Surfaces, AreMeasuredExactly) {
  const auto domain = surface_domain(box({-1, -1, -1}, {1, 1, 1}), {0.13, 2});
  const MeshSurface surface = meshed(*domain);
  const DistanceFigures found = measured(surface, *domain);
  EXPECT_TRUE(found.exact);
  const double step = 0.13 / (2 * steps);
  double greatest = 0;
  for (const Point3& p : surface.points) {
    const double c = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    greatest = std::max(greatest, std::abs(c - 1));
  }
  EXPECT_LE(greatest, found.to_shape.greatest + 2 * step);
  double corner = 0;
  const TriangleTree tree(surface.points, surface.triangles);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        corner = std::max(corner, std::sqrt(tree.nearest({x, y, z}).square));
  std::printf("to shape %.6f, to mesh %.6f, corner %.6f\n", found.to_shape.greatest,
              found.to_mesh.greatest, corner);
  EXPECT_GE(found.to_mesh.greatest, corner - 2 * step);
  EXPECT_LT(found.to_mesh.greatest, 0.13);
}

/// A box moved along an axis: its faces are that much off.
TEST(Surfaces, FindAShift) {
  const auto domain = surface_domain(box({-1, -1, -1}, {1, 1, 1}), {0.125, 2});
  const MeshSurface surface = meshed(*domain);
  const DistanceFigures there = measured(surface, *domain);
  const DistanceFigures found = measured(shifted(surface, {0.25, 0, 0}), *domain);
  EXPECT_NEAR(found.to_shape.greatest, 0.25, there.to_shape.greatest + 1e-6);
  EXPECT_NEAR(found.to_mesh.greatest, 0.25, there.to_mesh.greatest + 1e-6);
  EXPECT_NEAR(std::abs(found.to_mesh.at[0]), 1, 1e-5);
}

/// Triangles within the solid are not of its surface: it is known by its answers then.
TEST(Surfaces, WithinOthersDoNotCount) {
  const TriangleSurface nested =
      surfaces::both(box({-1, -1, -1}, {1, 1, 1}), box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const auto domain = surface_domain(nested, {0.125, 2});
  const DistanceFigures found = measured(meshed(*domain), *domain);
  EXPECT_FALSE(found.exact);
  EXPECT_LT(found.to_mesh.greatest, 0.125);
  Context context;
  const std::vector<Point3> within{{0.5, 0, 0}};
  EXPECT_NEAR(distances_from(*domain, false, within, context)[0], 0.5, 1e-3);
}

/// With holes that were closed, too.
TEST(Surfaces, WithHolesDoNotCount) {
  TriangleSurface open = box({-1, -1, -1}, {1, 1, 1});
  open.triangles.resize(10);
  const auto domain = open_surface_domain(open, {0.125, 2});
  const DistanceFigures found = measured(meshed(*domain), *domain);
  EXPECT_FALSE(found.exact);
  EXPECT_LT(found.to_mesh.greatest, 0.125);
}

}  // namespace
}  // namespace certet
