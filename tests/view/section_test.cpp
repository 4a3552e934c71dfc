// A flat cut: as large as the solid is there, with rims where labels meet.
#include "view/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ball.hpp"
#include "certet/examine.hpp"

namespace certet::view {
namespace {

double area_of_polygon(const SectionPolygon& polygon) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.corners; ++i)
    area += area_of(polygon.places[0], polygon.places[i], polygon.places[i + 1]);
  return area;
}

TEST(Section, IsAsLargeAsTheSolidIsThere) {
  const FileMesh mesh = ball(13);
  for (int axis = 0; axis < 3; ++axis)
    for (const double place : {-3.1, 0.2, 5.0})
      for (const bool below : {true, false}) {
        double area = 0;
        for (const SectionPolygon& polygon : section(mesh, {axis, place, below})) {
          area += area_of_polygon(polygon);
          for (std::size_t i = 0; i < polygon.corners; ++i)
            EXPECT_EQ(polygon.places[i][static_cast<std::size_t>(axis)], place);
        }
        const double truth = std::numbers::pi * (6.5 * 6.5 - place * place);
        EXPECT_NEAR(area, truth, 0.03 * truth);
      }
}

/// Each polygon is told apart from each other: what is cut out of all adds up, so that corners
/// in a wrong order, which make a polygon smaller, would show.
TEST(Section, HasNoGaps) {
  const FileMesh mesh = ball(9);
  const CutPlane plane{1, 0.37, false};
  std::map<std::array<Point3, 2>, int> sides;
  for (const SectionPolygon& polygon : section(mesh, plane))
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      std::array<Point3, 2> side{polygon.places[i], polygon.places[(i + 1) % polygon.corners]};
      std::ranges::sort(side);
      ++sides[side];
    }
  // Sides in one polygon alone are the outline, a closed line.
  std::map<Point3, int> ends;
  for (const auto& [side, polygons] : sides) {
    EXPECT_LE(polygons, 2);
    if (polygons == 1) ++ends[side[0]], ++ends[side[1]];
  }
  EXPECT_FALSE(ends.empty());
  for (const auto& [end, lines] : ends) EXPECT_EQ(lines, 2);
}

TEST(Section, HasRimsWhereLabelsMeet) {
  FileMesh mesh = ball(9);
  const CutPlane plane{0, 0.37, true};
  const auto rims = [&] {
    std::size_t count = 0;
    for (const SectionPolygon& polygon : section(mesh, plane))
      count += static_cast<std::size_t>(std::ranges::count(polygon.is_rim, true));
    return count;
  };
  std::map<std::array<Point3, 2>, std::vector<std::int32_t>> sides;
  for (const SectionPolygon& polygon : section(mesh, plane))
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      std::array<Point3, 2> side{polygon.places[i], polygon.places[(i + 1) % polygon.corners]};
      std::ranges::sort(side);
      sides[side].push_back(mesh.labels[polygon.tet]);
    }
  std::size_t expected = 0, outline = 0;
  for (const auto& [side, labels] : sides) {
    if (labels.size() == 1) ++outline;
    if (labels.size() == 1 || labels[0] != labels[1]) expected += labels.size();
  }
  EXPECT_EQ(rims(), expected);
  EXPECT_GT(rims(), outline);
  mesh.labels.clear();
  EXPECT_EQ(rims(), outline);
}

}  // namespace
}  // namespace certet::view
