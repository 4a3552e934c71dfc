// Meshes measured from their shapes, and shapes from their meshes, where the figures are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "certet/bounded_function.hpp"
#include "certet/error.hpp"
#include "certet/materials_domain.hpp"
#include "shapes.hpp"

namespace certet {
namespace {

using namespace shapes;

/// The greatest of |r - 1| over the vertices, middles and centroids of a surface.
double from_unit_sphere(const MeshSurface& surface) {
  double greatest = 0;
  const auto see = [&](std::initializer_list<std::uint32_t> corners) {
    Point3 middle{0, 0, 0};
    for (const std::uint32_t corner : corners)
      for (std::size_t a = 0; a < 3; ++a)
        middle[a] += surface.points[corner][a] / static_cast<double>(corners.size());
    greatest = std::max(greatest, std::abs(length(middle) - 1));
  };
  for (const auto& [a, b, c] : surface.triangles) {
    see({a});
    see({b});
    see({c});
    see({a, b});
    see({b, c});
    see({c, a});
    see({a, b, c});
  }
  return greatest;
}

TEST(Figures, OfABallAreThoseOfItsRadii) {
  const ShapeDomain ball = shape("sphere:1", 0.1);
  const MeshSurface surface = meshed(ball);
  const DistanceFigures found = measured(surface, ball);
  const double greatest = from_unit_sphere(surface);
  std::printf("to shape %.6f rms %.6f, to mesh %.6f rms %.6f, true %.6f\n", found.to_shape.greatest,
              found.to_shape.rms, found.to_mesh.greatest, found.to_mesh.rms, greatest);
  EXPECT_NEAR(found.to_shape.greatest, greatest, 0.01 * greatest);
  EXPECT_NEAR(std::abs(length(found.to_shape.at) - 1), greatest, 0.01 * greatest);
  EXPECT_NEAR(length(found.to_mesh.at), 1, 1e-5);  // a point of the shape
  EXPECT_NEAR(found.to_mesh.greatest, greatest, 0.1 * greatest);
  EXPECT_NEAR(found.to_mesh.rms, found.to_shape.rms, 0.15 * found.to_shape.rms);
  EXPECT_EQ(found.edge, 0.1);
  EXPECT_FALSE(found.exact);
}

/// Planted: the mesh lies elsewhere.
TEST(Figures, FindAShift) {
  const ShapeDomain box = shape("sphere:1", 0.05);
  const MeshSurface surface = meshed(box);
  const DistanceFigures there = measured(surface, box);
  for (const Point3& by : {Point3{0.2, 0, 0}, Point3{0.03, -0.04, 0.12}}) {
    const DistanceFigures found = measured(shifted(surface, by), box);
    const double off = there.to_shape.greatest + 1e-3;
    EXPECT_NEAR(found.to_shape.greatest, length(by), off);
    EXPECT_NEAR(found.to_mesh.greatest, length(by), off);
    // Over a sphere the square of the shift along the normal is a third of its own.
    EXPECT_NEAR(found.to_shape.rms, length(by) / std::sqrt(3), 0.1 * length(by));
    EXPECT_NEAR(found.to_mesh.rms, length(by) / std::sqrt(3), 0.1 * length(by));
  }
}

/// Planted: a ball of the mesh is not there, which only one of the directions sees.
TEST(Figures, FindWhatTheMeshLacks) {
  const auto balls = [](bool both) {
    return BoundedFunction(
        [both](Point3 p) {
          const double one = length(p) - 1, other = length({p[0] - 3, p[1], p[2]}) - 0.5;
          return both ? std::min(one, other) : one;
        },
        {{-1.5, -1.5, -1.5}, {4, 1.5, 1.5}}, 0.1);
  };
  const DistanceFigures found = measured(meshed(balls(false)), balls(true));
  EXPECT_LT(found.to_shape.greatest, 0.02);
  EXPECT_NEAR(found.to_mesh.greatest, 2.5, 0.02);
  EXPECT_NEAR(found.to_mesh.at[0], 3.5, 0.02);
}

/// Planted: the mesh has an inner wall that the shape does not have, or has elsewhere.
TEST(Figures, SeeInterfaces) {
  const auto nested = [](double radius) {
    return materials_domain({{"outer", shape_solid("sphere:1")},
                             {"inner", shape_solid("sphere:" + std::to_string(radius))}},
                            {0.1, 2});
  };
  const MeshSurface surface = meshed(*nested(0.5));
  EXPECT_TRUE(surface.interfaces);
  EXPECT_LT(measured(surface, *nested(0.5)).to_shape.greatest, 0.02);
  EXPECT_NEAR(measured(surface, *nested(0.6)).to_shape.greatest, 0.1, 0.01);
  EXPECT_NEAR(measured(surface, *nested(0.6)).to_mesh.greatest, 0.1, 0.01);
}

/// The same mesh, counted, in memory or as a file has it; any number of threads.
TEST(Figures, AreTheSameHoweverTheMeshIsMade) {
  const ShapeDomain torus = shape("torus:1,0.4", 0.1);
  Context one;
  one.threads = 1;
  Context three;
  three.threads = 3;
  const Stuffing stuffing(torus, torus.lattice(), Method::embedded, one);
  const Mesh written = mesh(torus, stuffing, one);
  const DistanceFigures counted =
      measure_distance(surface_of(stuffing, torus.frame(), one), torus, one);
  const DistanceFigures in_memory = measure_distance(surface_of(written, three), torus, three);
  const Buffer<Point3> points = world_points(written);
  const DistanceFigures of_points = measure_distance(
      surface_of({points.data(), points.size()}, survey(written, one), false), torus, three);
  for (const DistanceFigures& other : {in_memory, of_points})
    for (const auto way : {&DistanceFigures::to_shape, &DistanceFigures::to_mesh}) {
      EXPECT_EQ((counted.*way).greatest, (other.*way).greatest);
      EXPECT_EQ((counted.*way).rms, (other.*way).rms);
      EXPECT_EQ((counted.*way).at, (other.*way).at);
      EXPECT_EQ((counted.*way).points, (other.*way).points);
    }
}

TEST(Figures, NeedSurfaces) {
  const ShapeDomain ball = shape("sphere:1", 0.1);
  const BoundedFunction nothing([](Point3) { return 1.0; }, {{-1, -1, -1}, {1, 1, 1}}, 0.1);
  EXPECT_THROW(measured({}, ball), Error);
  EXPECT_THROW(measured(meshed(ball), nothing), Error);
}

}  // namespace
}  // namespace certet
