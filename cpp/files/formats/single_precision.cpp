#include "single_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace certet::formats {
namespace {

constexpr double least_cosine = 0.99691733373312796;  // of 4.5 degrees

float nearest_single(double number) {
  constexpr double greatest = std::numeric_limits<float>::max();
  constexpr float infinite = std::numeric_limits<float>::infinity();
  if (std::fabs(number) > greatest) return number > 0 ? infinite : -infinite;
  return static_cast<float>(number);
}

Point3 widened(const Single3& p) { return {p[0], p[1], p[2]}; }

template <class Number>
bool is_finite(const std::array<Number, 3>& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

double greatest_magnitude(const Point3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Scaled by a power of two, which is exact, so that products stay in range.
Point3 scaled(const Point3& v, int exponent) {
  return {std::scalbn(v[0], exponent), std::scalbn(v[1], exponent), std::scalbn(v[2], exponent)};
}

struct Placed {
  Single3 single;
  Point3 point;
};

}  // namespace

Single3 single(const Point3& p) {
  return {nearest_single(p[0]), nearest_single(p[1]), nearest_single(p[2])};
}

Point3 normal_of(const Triangle3& triangle) {
  const auto& [a, b, c] = triangle;
  Point3 u = difference(b, a), v = difference(c, a);
  const double greatest = std::max(greatest_magnitude(u), greatest_magnitude(v));
  if (!(greatest > 0) || !std::isfinite(greatest)) return {0, 0, 0};
  const int exponent = -std::ilogb(greatest);
  u = scaled(u, exponent);
  v = scaled(v, exponent);
  const Point3 n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                 u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(dot(n, n));
  if (!(length > 0)) return {0, 0, 0};
  return {n[0] / length, n[1] / length, n[2] / length};
}

void SinglePrecisionCheck::add(const Triangle3& triangle) {
  ++triangles_;
  const Point3 before = normal_of(triangle);
  if (before == Point3{}) return;
  const auto& [a, b, c] = triangle;
  const Point3 after = normal_of({widened(single(a)), widened(single(b)), widened(single(c))});
  if (!(dot(before, after) >= least_cosine)) ++turned_;
}

void SinglePrecisionCheck::add(std::span<const Point3> points) {
  points_ += points.size();
  std::vector<Placed> placed;
  placed.reserve(points.size());
  for (const Point3& point : points) {
    const Single3 rounded = single(point);
    if (!is_finite(point)) continue;
    if (is_finite(rounded))
      placed.push_back({rounded, point});
    else
      ++infinite_;
  }
  std::ranges::sort(placed, [](const Placed& one, const Placed& other) {
    return one.single != other.single ? one.single < other.single : one.point < other.point;
  });
  for (std::size_t i = 1; i < placed.size(); ++i)
    if (placed[i].single == placed[i - 1].single && placed[i].point != placed[i - 1].point)
      ++joined_;
}

std::string SinglePrecisionCheck::loss() const {
  std::string words;
  const auto add = [&words](std::uint64_t count, std::uint64_t all, const char* what) {
    if (count == 0) return;
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " of " + std::to_string(all) +
             " " + what;
  };
  add(infinite_, points_, "points would be beyond its numbers");
  add(joined_, points_, "points would fall upon others");
  add(turned_, triangles_, "triangles would be flat or turned");
  return words;
}

}  // namespace certet::formats
