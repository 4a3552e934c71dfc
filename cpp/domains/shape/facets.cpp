#include "facets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace certet::shape {
namespace {

Coord3 step_of(const Frame& frame, const Point3& world) {
  const Point3 at = frame.position(world);
  const auto whole = [](double c) { return static_cast<std::int32_t>(std::lround(steps * c)); };
  return {whole(at[0]), whole(at[1]), whole(at[2])};
}

/// Faces between a polygon and another, both anticlockwise seen from where the second lies, and
/// these two, from points within them.
std::vector<TriangleCorners> prism(const std::vector<Coord3>& low, const std::vector<Coord3>& high,
                                   Coord3 in_low, Coord3 in_high) {
  std::vector<TriangleCorners> triangles;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t j = (i + 1) % low.size();
    triangles.push_back({low[i], low[j], high[j]});
    triangles.push_back({low[i], high[j], high[i]});
    triangles.push_back({in_low, low[j], low[i]});
    triangles.push_back({in_high, high[i], high[j]});
  }
  return triangles;
}

}  // namespace

std::vector<TriangleCorners> facets_of(const Box& box, const Frame& frame) {
  const Point3 &a = box.sides.low, &b = box.sides.high;
  const auto corners = [&](double z) {
    return std::vector{step_of(frame, {a[0], a[1], z}), step_of(frame, {b[0], a[1], z}),
                       step_of(frame, {b[0], b[1], z}), step_of(frame, {a[0], b[1], z})};
  };
  const double x = (a[0] + b[0]) / 2, y = (a[1] + b[1]) / 2;
  return prism(corners(a[2]), corners(b[2]), step_of(frame, {x, y, a[2]}),
               step_of(frame, {x, y, b[2]}));
}

std::vector<TriangleCorners> facets_of(const Cylinder& cylinder, const Frame& frame) {
  constexpr double most_sides = 10'000;
  const double radius = cylinder.radius / frame.size * (2.0 * steps);
  // The middle of a side is radius (1 - cos(pi / n)) within.
  const double sides =
      std::clamp(std::ceil(std::numbers::pi * std::sqrt(radius / 2)), 8.0, most_sides);
  const auto circle = [&](double z) {
    std::vector<Coord3> points;
    for (double i = 0; i < sides; ++i) {
      const double angle = i / sides * (2 * std::numbers::pi);
      points.push_back(step_of(frame, {cylinder.radius * std::cos(angle),
                                       cylinder.radius * std::sin(angle), z}));
    }
    return points;
  };
  const double h = cylinder.half_height;
  return prism(circle(-h), circle(h), step_of(frame, {0, 0, -h}), step_of(frame, {0, 0, h}));
}

}  // namespace certet::shape
