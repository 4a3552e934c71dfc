#include <algorithm>
#include <cmath>

#include "runs.hpp"
#include "shape_points.hpp"
#include "vectors.hpp"

namespace certet::distance {
namespace {

/// The corners and the centroid, for a twelfth of the area each and the rest.
void add_points(const Point3& a, const Point3& b, const Point3& c, std::vector<ShapePoint>& out) {
  const double area = length(normal(a, b, c)) / 2;
  for (const Point3& corner : {a, b, c}) out.push_back({corner, area / 12});
  out.push_back({centroid(a, b, c), 0.75 * area});
}

void add_parts(const TriangleCorners& triangle, std::vector<ShapePoint>& out) {
  const Point3 a = in_units(triangle[0]), b = in_units(triangle[1]), c = in_units(triangle[2]);
  const double longest =
      std::max({length(difference(b, a)), length(difference(c, b)), length(difference(a, c))});
  const int parts = std::max(1, static_cast<int>(std::ceil(longest)));
  const auto at = [&](int i, int j) {
    const double u = double(i) / parts, v = double(j) / parts;
    return sum(a, sum(scaled(u, difference(b, a)), scaled(v, difference(c, a))));
  };
  for (int j = 0; j < parts; ++j)
    for (int i = 0; i + j < parts; ++i) {
      add_points(at(i, j), at(i + 1, j), at(i, j + 1), out);
      if (i + j + 1 < parts) add_points(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), out);
    }
}

}  // namespace

std::vector<ShapePoint> points_of(std::span<const TriangleCorners> triangles, Context& context) {
  std::vector<std::vector<ShapePoint>> parts(run_count(triangles.size()));
  in_runs(triangles.size(), context, [&](std::size_t first, std::size_t last, std::size_t run) {
    for (std::size_t t = first; t < last; ++t) add_parts(triangles[t], parts[run]);
  });
  std::vector<ShapePoint> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool all_part(std::span<const TriangleCorners> triangles, const Sides& sides, Context& context) {
  // Farther than the corners are from where they were before they were rounded.
  constexpr double aside = 4.0 / steps;
  std::vector<std::uint8_t> parted(run_count(triangles.size()), 1);
  in_runs(triangles.size(), context, [&](std::size_t first, std::size_t last, std::size_t run) {
    Question question(sides);
    for (std::size_t t = first; t < last; ++t) {
      const Point3 a = in_units(triangles[t][0]), b = in_units(triangles[t][1]), c = in_units(triangles[t][2]);
      const Point3 n = normal(a, b, c);
      if (!(dot(n, n) > 0)) continue;
      const Point3 way = scaled(aside, unit(n)), middle = centroid(a, b, c);
      question.add(sum(middle, way));
      question.add(difference(middle, way));
    }
    question.ask();
    for (std::size_t i = 0; i < question.size(); i += 2)
      if (question[i] == question[i + 1]) parted[run] = 0;
  });
  return std::ranges::all_of(parted, [](std::uint8_t one) { return one != 0; });
}

}  // namespace certet::distance
