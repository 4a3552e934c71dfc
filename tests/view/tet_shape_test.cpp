// Shapes of tetrahedra that are known.
#include "certet/tet_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "ball.hpp"
#include "certet/quality.hpp"

namespace certet {
namespace {

TEST(Shape, Regular) {
  const TetShape shape = shape_of({{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}});
  EXPECT_NEAR(shape.least_dihedral, 70.528779, 1e-6);
  EXPECT_NEAR(shape.greatest_dihedral, 70.528779, 1e-6);
  EXPECT_NEAR(shape.worst_angle(), 70.528779, 1e-6);
  EXPECT_NEAR(shape.aspect, std::sqrt(1.5), 1e-12);
  EXPECT_NEAR(shape.shortest_edge, std::sqrt(8), 1e-12);
}

TEST(Shape, OfTheLattice) {
  const TetShape shape = shape_of({{{0, 0, 0}, {2, 0, 0}, {1, 1, 1}, {1, 1, -1}}});
  EXPECT_NEAR(shape.least_dihedral, 60, 1e-9);
  EXPECT_NEAR(shape.greatest_dihedral, 90, 1e-9);
  EXPECT_NEAR(shape.aspect, std::sqrt(2), 1e-12);
  EXPECT_NEAR(shape.longest_edge, 2, 1e-12);
}

TEST(Shape, Flat) {
  const TetShape shape = shape_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}});
  EXPECT_TRUE(std::isnan(shape.worst_angle()));
  EXPECT_TRUE(std::isinf(shape.aspect));
}

TEST(Shape, ExtremesAreThoseOfTheMeasure) {
  const FileMesh mesh = view::ball(12);
  double least = 180, greatest = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const TetShape shape =
        shape_of({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    least = std::min(least, shape.least_dihedral);
    greatest = std::max(greatest, shape.greatest_dihedral);
  }
  const Quality quality =
      measure_world(mesh.points, 0, std::span<const Tet<std::uint64_t>>(mesh.tets));
  EXPECT_NEAR(least, quality.min_dihedral, 1e-9);
  EXPECT_NEAR(greatest, quality.max_dihedral, 1e-9);
}

TEST(Survey, CountsEveryTetrahedronAndEdge) {
  FileMesh mesh = view::ball(12);
  const std::uint64_t tets = mesh.tets.size();
  mesh.tets.push_back({0, 1, 2, mesh.points.size()});
  const ShapeSurvey survey = survey_shapes(mesh.points, mesh.tets);
  EXPECT_EQ(survey.tets, tets);
  EXPECT_EQ(std::accumulate(survey.aspects.begin(), survey.aspects.end(), std::uint64_t{0}), tets);
  EXPECT_EQ(std::accumulate(survey.edges.begin(), survey.edges.end(), std::uint64_t{0}), 6 * tets);
  EXPECT_GT(survey.edges.front(), 0u);
  EXPECT_GT(survey.edges.back(), 0u);
}

/// Squares of such numbers are infinite, and so would be what is made of them.
TEST(Survey, WithoutCornersThatAreNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : {1e200, -1e51, 1e308, nan}) {
    const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {far, 0, 0}};
    const std::vector<Tet<std::uint64_t>> tets{{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 4, 2, 3}};
    const ShapeSurvey survey = survey_shapes(points, tets);
    EXPECT_EQ(survey.tets, 1U) << far;
    EXPECT_EQ(survey.longest_edge, std::sqrt(2.0)) << far;
  }
}

TEST(Survey, OfCornersFarAwayOrClose) {
  for (const double far : {1e50, 1e-200, 5e-324}) {
    const std::vector<Point3> points{{0, 0, 0}, {far, 0, 0}, {0, far, 0}, {0, 0, far}};
    const std::vector<Tet<std::uint64_t>> tets{{0, 1, 2, 3}};
    const ShapeSurvey survey = survey_shapes(points, tets);
    EXPECT_EQ(survey.tets, 1U);
    EXPECT_TRUE(std::isfinite(survey.longest_edge));
    EXPECT_EQ(std::accumulate(survey.edges.begin(), survey.edges.end(), std::uint64_t{0}), 6U);
  }
}

TEST(Survey, OfNothing) {
  const ShapeSurvey survey = survey_shapes({}, {});
  EXPECT_EQ(survey.tets, 0u);
  EXPECT_EQ(survey.greatest_aspect, 0);
}

}  // namespace
}  // namespace certet
