// Of two triangles, the nearer is seen, whichever is drawn first.
#include "view/canvas.hpp"

#include <gtest/gtest.h>

namespace certet::view {
namespace {

constexpr int side = 32;
constexpr Light red{1, 0, 0}, blue{0, 0, 1};

/// Covers the canvas.
DrawnTriangle wide(Light color, float nearness) {
  DrawnTriangle triangle;
  triangle.corners = {OnCanvas{-40, -40, nearness}, OnCanvas{120, -40, nearness},
                      OnCanvas{-40, 120, nearness}};
  triangle.normals = {Vec{0, 0, 1}, Vec{0, 0, 1}, Vec{0, 0, 1}};
  triangle.color = color;
  return triangle;
}

/// Whether the middle is red when red is drawn at one depth and blue at another.
bool red_seen(float red_at, float blue_at, bool red_first) {
  Canvas canvas(side, side);
  canvas.draw(red_first ? wide(red, red_at) : wide(blue, blue_at));
  canvas.draw(red_first ? wide(blue, blue_at) : wide(red, red_at));
  const Picture picture = canvas.develop();
  const std::size_t middle = 3 * (side * side / 2 + side / 2);
  return picture.rgb[middle] > picture.rgb[middle + 2];
}

/// Holds if nearness 1.2 hides 1.0; `flip` plants an inverted depth.
bool nearer_is_seen(bool flip) {
  const auto depth = [flip](float nearness) { return flip ? 2 - nearness : nearness; };
  return red_seen(depth(1.2F), depth(1.0F), true) && red_seen(depth(1.2F), depth(1.0F), false) &&
         !red_seen(depth(1.0F), depth(1.2F), true) && !red_seen(depth(1.0F), depth(1.2F), false);
}

TEST(Canvas, NearerIsSeen) { EXPECT_TRUE(nearer_is_seen(false)); }

TEST(Canvas, InvertedDepthIsNoticed) { EXPECT_FALSE(nearer_is_seen(true)); }

TEST(Canvas, TriangleCoversItsHalf) {
  Canvas canvas(side, side);
  DrawnTriangle half = wide(red, 1);
  half.corners = {OnCanvas{0, 0, 1}, OnCanvas{side, 0, 1}, OnCanvas{0, side, 1}};
  canvas.draw(half);
  const Picture picture = canvas.develop();
  int covered = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    covered += picture.rgb[i] > picture.rgb[i + 2] + 100 ? 1 : 0;
  EXPECT_NEAR(covered, 0.5 * side * side, side);
}

TEST(Canvas, EdgesAreDark) {
  Canvas plain(side, side), edged(side, side);
  DrawnTriangle triangle = wide(red, 1);
  triangle.corners = {OnCanvas{2, 2, 1}, OnCanvas{30, 2, 1}, OnCanvas{2, 30, 1}};
  plain.draw(triangle);
  triangle.edges.fill({0.8F, 0.75F});
  edged.draw(triangle);
  const std::size_t on_edge = 3 * (10 * side + 2), inside = 3 * (10 * side + 10);
  EXPECT_LT(edged.develop().rgb[on_edge] + 30, plain.develop().rgb[on_edge]);
  EXPECT_EQ(edged.develop().rgb[inside], plain.develop().rgb[inside]);
}

}  // namespace
}  // namespace certet::view
