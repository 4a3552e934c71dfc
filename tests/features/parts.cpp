#include "parts.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace parts {
namespace {

using certet::Point3;
using certet::TriangleSurface;

constexpr double pi = std::numbers::pi;

double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

void add_arc(Polygon& polygon, double radius, double from, double to, int sides, double x) {
  for (int i = 0; i <= sides; ++i) {
    const double angle = from + (to - from) * i / sides;
    polygon.push_back({x + radius * std::cos(angle), radius * std::sin(angle)});
  }
}

void cut_in_four(TriangleSurface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b),
                                                  static_cast<std::uint32_t>(surface.points.size()));
    if (is_new) {
      const Point3 p = surface.points[a], q = surface.points[b];
      surface.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
    }
    return at->second;
  };
  std::vector<std::array<std::uint32_t, 3>> finer;
  for (const auto& [a, b, c] : surface.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::array<std::uint32_t, 3>& one :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      finer.push_back(one);
  }
  surface.triangles = std::move(finer);
}

}  // namespace

Part prism(const Polygon& polygon, std::array<double, 2> centre, double height) {
  Part part;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {0.0, height})
    for (const auto& [x, y] : polygon) part.surface.points.push_back({x, y, z});
  part.surface.points.push_back({centre[0], centre[1], 0});
  part.surface.points.push_back({centre[0], centre[1], height});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    part.surface.triangles.insert(part.surface.triangles.end(),
                                  {{i, j, j + n}, {i, j + n, i + n}, {2 * n, j, i},
                                   {2 * n + 1, i + n, j + n}});
  }
  part.volume = area_of(polygon) * height;
  return part;
}

Part box(double a, double b, double c) {
  return prism({{0, 0}, {a, 0}, {a, b}, {0, b}}, {a / 2, b / 2}, c);
}

Part cylinder(double radius, double height, int sides) {
  Polygon polygon;
  for (int i = 0; i < sides; ++i)
    polygon.push_back({radius * std::cos(2 * pi * i / sides), radius * std::sin(2 * pi * i / sides)});
  return prism(polygon, {0, 0}, height);
}

Part angle_beam(double leg, double length) {
  return prism({{0, 0}, {leg, 0}, {leg, 1}, {1, 1}, {1, leg}, {0, leg}}, {0.5, 0.5}, length);
}

Part star(double outer, double inner, double height) {
  Polygon polygon;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 == 0 ? inner : outer;
    polygon.push_back({radius * std::cos(pi * i / 5), radius * std::sin(pi * i / 5)});
  }
  return prism(polygon, {0, 0}, height);
}

Part rounded_block(double radius, double length, double height, int sides) {
  Polygon polygon;
  add_arc(polygon, radius, -pi / 2, pi / 2, sides, length / 2);
  polygon.push_back({-length / 2, radius});
  polygon.push_back({-length / 2, -radius});
  return prism(polygon, {0, 0}, height);
}

Part drop(double height, int sides) {
  Polygon polygon;
  add_arc(polygon, 1, pi / 4, 7 * pi / 4, sides, 0);
  polygon.push_back({std::sqrt(2.0), 0});
  return prism(polygon, {0, 0}, height);
}

Part placed(Part part, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::array<double, 4> q;
  double square = 0;
  for (double& c : q) {
    c = normal(random);
    square += c * c;
  }
  for (double& c : q) c /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  const double turn[3][3] = {
      {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
      {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
      {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  Point3 shift;
  for (double& c : shift) c = std::uniform_real_distribution(-1.0, 1.0)(random);
  for (Point3& p : part.surface.points) {
    Point3 there = shift;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) there[i] += turn[i][j] * p[j];
    p = there;
  }
  return part;
}

TriangleSurface rough(TriangleSurface surface, int times, double noise, std::mt19937_64& random) {
  for (int i = 0; i < times; ++i) cut_in_four(surface);
  std::normal_distribution<double> normal(0, noise);
  for (Point3& p : surface.points)
    for (double& c : p) c += normal(random);
  return surface;
}

TriangleSurface ball(int times) {
  TriangleSurface surface;
  surface.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                       {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int i = 0; i < times; ++i) cut_in_four(surface);
  for (Point3& p : surface.points) {
    const double size = std::hypot(p[0], p[1], p[2]);
    for (double& c : p) c /= size;
  }
  return surface;
}

}  // namespace parts
