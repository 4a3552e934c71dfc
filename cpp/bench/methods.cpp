/// A table of the methods over some shapes, for cpp/docs/methods.md.
///
/// usage: certet_bench_methods
/// Each shape is meshed at eight places in the lattice.  Angles are in degrees, distances of the
/// surface's vertices, middles of edges and centroids from that of the shape in long edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "certet/function_domain.hpp"
#include "certet/stuffing.hpp"

namespace {

using namespace certet;

using Level = std::function<double(const Point3&)>;

/// A shape within a ball of radius 1.5 around 0; its level may be its distance.
struct Shape {
  std::string name;
  double size;  ///< of a long edge
  Level level;
  bool is_distance;
};

double torus(const Point3& p) { return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4; }
double ball(const Point3& p) { return std::hypot(p[0], p[1], p[2]) - 1; }
/// Two sheets of a gyroid, cut off by a ball.
double gyroid(const Point3& p) {
  const double sheet = std::sin(6 * p[0]) * std::cos(6 * p[1]) +
                       std::sin(6 * p[1]) * std::cos(6 * p[2]) +
                       std::sin(6 * p[2]) * std::cos(6 * p[0]);
  return std::max(std::abs(sheet) - 0.6, 8 * ball(p));
}

/// The shape of voxels of this side whose centres are inside.
Level voxels(const Level& shape, double side) {
  return [=](const Point3& p) {
    Point3 centre{};
    for (std::size_t a = 0; a < 3; ++a) centre[a] = side * (std::floor(p[a] / side) + 0.5);
    return shape(centre) <= 0 ? -1.0 : 1.0;
  };
}

/// The n-th of eight places, in long edges; they spread evenly.
Point3 place(int n) {
  Point3 at{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double step = std::array{0.8191725134, 0.6710436067, 0.5497004779}[a];
    at[a] = n * step - std::floor(n * step);
  }
  return at;
}

using Vector = Point3;
Vector minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Measured {
  double least = 180, greatest = 0;
  double tets = 0, violated = 0, stayed = 0;
  double squares = 0, count = 0, farthest = 0;

  void add_angles(const std::array<Point3, 4>& p) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t k = (i != 0 && j != 0) ? 0 : (i != 1 && j != 1) ? 1 : 2;
        const std::size_t l = 6 - i - j - k;
        const Vector edge = minus(p[j], p[i]);
        const Vector a = cross(edge, minus(p[k], p[i]));
        const Vector b = cross(edge, minus(p[l], p[i]));
        const double angle = 180 / std::numbers::pi *
                             std::acos(std::clamp(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)), -1.0, 1.0));
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
      }
  }

  void add_distance(double distance) {
    squares += distance * distance;
    ++count;
    farthest = std::max(farthest, std::abs(distance));
  }
};

template <class Index>
void measure(const Mesh& mesh, const std::vector<Tet<Index>>& tets, const Shape& shape,
             const Point3& at, Measured& found) {
  const auto point = [&](Index n) {
    Point3 p = mesh.frame.world(mesh.points[n]);
    for (std::size_t a = 0; a < 3; ++a) p[a] -= at[a];
    return p;
  };
  std::map<std::array<Index, 3>, int> faces;
  for (const Tet<Index>& tet : tets) {
    found.add_angles({point(tet[0]), point(tet[1]), point(tet[2]), point(tet[3])});
    if (!shape.is_distance) continue;
    for (std::size_t across = 0; across < 4; ++across) {
      std::array<Index, 3> face{};
      for (std::size_t n = 0; n < 3; ++n) face[n] = tet[n < across ? n : n + 1];
      std::ranges::sort(face);
      ++faces[face];
    }
  }
  const auto middle = [&](std::initializer_list<Index> corners) {
    Point3 sum{};
    for (const Index n : corners)
      for (std::size_t a = 0; a < 3; ++a)
        sum[a] += point(n)[a] / static_cast<double>(corners.size());
    return shape.level(sum) / shape.size;
  };
  for (const auto& [face, times] : faces) {
    if (times != 1) continue;
    const auto [a, b, c] = face;
    for (const double distance : {middle({a}), middle({b}), middle({c}), middle({a, b}),
                                  middle({b, c}), middle({c, a}), middle({a, b, c})})
      found.add_distance(distance);
  }
}

Measured measure(const Shape& shape, Method method, int number) {
  Point3 at = place(number);
  for (double& c : at) c *= shape.size;
  const Frame frame{.size = shape.size};
  const FunctionDomain domain(
      [&](const Point3& p) { return shape.level(minus(p, at)); }, frame);
  const int cells = static_cast<int>(std::ceil(1.5 / shape.size)) + 3;
  const Lattice lattice{{-2 * cells, -2 * cells, -2 * cells}, {2 * cells, 2 * cells, 2 * cells}};
  Context context;
  const Stuffing stuffing(domain, lattice, method, context);
  const Mesh mesh = emit(stuffing, frame, context);
  Measured found;
  found.tets = static_cast<double>(stuffing.tet_count());
  found.violated = static_cast<double>(stuffing.warp_figures().violated);
  found.stayed = static_cast<double>(stuffing.warp_figures().stayed);
  std::visit([&]<class Tets>(const Tets& tets) {
    using Index = std::remove_cvref_t<decltype(tets[0][0])>;
    measure(mesh, std::vector<Tet<Index>>(tets.begin(), tets.end()), shape, at, found);
  }, mesh.tets);
  return found;
}

void tell(const Shape& shape, Method method) {
  Measured all;
  double sum_of_least = 0;
  constexpr int places = 8;
  for (int n = 0; n < places; ++n) {
    const Measured one = measure(shape, method, n);
    all.least = std::min(all.least, one.least);
    all.greatest = std::max(all.greatest, one.greatest);
    sum_of_least += one.least;
    all.tets += one.tets / places;
    all.violated += one.violated;
    all.stayed += one.stayed;
    all.squares += one.squares;
    all.count += one.count;
    all.farthest = std::max(all.farthest, one.farthest);
  }
  std::printf("| %s | %s | %.1f (%.1f) | %.1f | %.0f | ", shape.name.c_str(), name(method).data(),
              all.least, sum_of_least / places, all.greatest, all.tets);
  if (shape.is_distance)
    std::printf("%.5f | %.4f | ", std::sqrt(all.squares / all.count), all.farthest);
  else
    std::printf("- | - | ");
  if (all.violated > 0) std::printf("%.1f %% |\n", 100 * all.stayed / all.violated);
  else std::printf("- |\n");
  std::fflush(stdout);
}

}  // namespace

int main() {
  constexpr double size = 0.085;
  const std::vector<Shape> shapes{
      {"torus", size, torus, true},
      {"ball", size, ball, true},
      {"gyroid", size, gyroid, false},
      {"torus of voxels of 1 edge", size, voxels(torus, size), false},
      {"torus of voxels of 1/2 edge", size, voxels(torus, size / 2), false},
      {"ball of voxels of 1 edge", size, voxels(ball, size), false},
      {"ball of voxels of 1/2 edge", size, voxels(ball, size / 2), false},
  };
  std::printf("| shape | method | least (mean) | greatest | tetrahedra | rms | farthest | stayed |\n"
              "|---|---|---|---|---|---|---|---|\n");
  for (const Shape& shape : shapes)
    for (const Method method : {Method::angles, Method::embedded, Method::embedding, Method::key})
      tell(shape, method);
}
