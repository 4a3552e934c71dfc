// A surface of few triangles still lies where the fine one does.
#include "view/coarse_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ball.hpp"

namespace certet::view {
namespace {

TEST(CoarseSurface, IsTheSurfaceWhereThatIsSmall) {
  const FileMesh mesh = ball(9);
  const auto border = separating_faces(mesh, {});
  const CoarseSurface surface = coarse_surface(mesh, border, border.size());
  EXPECT_EQ(surface.cell, 0);
  EXPECT_EQ(surface.triangles.size(), border.size());
}

TEST(CoarseSurface, KeepsToItsLimit) {
  const FileMesh mesh = ball(20);
  const auto border = separating_faces(mesh, {});
  for (const std::uint64_t limit : {1000u, 200u, 40u}) {
    const CoarseSurface surface = coarse_surface(mesh, border, limit);
    EXPECT_LE(surface.triangles.size(), limit);
    EXPECT_GT(surface.triangles.size(), limit / 8);
    EXPECT_GT(surface.cell, 0);
    for (const Point3& p : surface.points)
      EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 10, surface.cell);
  }
}

}  // namespace
}  // namespace certet::view
