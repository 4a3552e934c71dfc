#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "certet/survey.hpp"
#include "exact.hpp"
#include "mesh_numbers.hpp"

namespace judge {
namespace {

using certet::Coord3;
using certet::Mesh;
using Point = std::array<double, 3>;

constexpr double long_edge = 2.0 * certet::steps;

Point in_doubles(Coord3 p) { return {double(p.x), double(p.y), double(p.z)}; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double size(const Point& a) { return std::sqrt(dot(a, a)); }

double from_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = minus(b, a), to = minus(p, a);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
  return size(minus(to, {share * along[0], share * along[1], share * along[2]}));
}

double from_triangle(const Point& p, const certet::TriangleCorners& t) {
  const Point a = in_doubles(t[0]), b = in_doubles(t[1]), c = in_doubles(t[2]);
  const Point normal = cross(minus(b, a), minus(c, a));
  const auto within = [&](const Point& from, const Point& to) {
    return dot(cross(minus(to, from), minus(p, from)), normal) >= 0;
  };
  if (size(normal) > 0 && within(a, b) && within(b, c) && within(c, a))
    return std::fabs(dot(minus(p, a), normal)) / size(normal);
  return std::min({from_segment(p, a, b), from_segment(p, b, c), from_segment(p, c, a)});
}

std::vector<std::array<std::uint64_t, 3>> boundary_of(const Mesh& mesh) {
  std::vector<std::array<std::uint64_t, 3>> faces;
  certet::Context context;
  for (const auto& face : certet::survey(mesh, context).boundary) faces.push_back(face.points);
  return faces;
}

/// Edges of the boundary, by cubes of a long edge.
class Edges {
 public:
  explicit Edges(const Mesh& mesh) {
    for (const auto& [a, b, c] : boundary_of(mesh))
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        if (from < to) add(in_doubles(mesh.points[from]), in_doubles(mesh.points[to]));
  }
  /// Of a point, in long edges, 2 where none is near.
  [[nodiscard]] double nearest(const Point& p) const {
    double least = 2 * long_edge;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          auto [x, y, z] = cube_of(p);
          const auto found = cubes_.find({x + i, y + j, z + k});
          if (found == cubes_.end()) continue;
          for (const auto& [a, b] : found->second) least = std::min(least, from_segment(p, a, b));
        }
    return least / long_edge;
  }

 private:
  using Cube = std::array<int, 3>;
  static Cube cube_of(const Point& p) {
    return {int(std::floor(p[0] / long_edge)), int(std::floor(p[1] / long_edge)),
            int(std::floor(p[2] / long_edge))};
  }
  void add(const Point& a, const Point& b) {
    std::set<Cube> cubes;
    for (int i = 0; i <= 8; ++i) {
      const double share = i / 8.0;
      cubes.insert(cube_of({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                            a[2] + share * (b[2] - a[2])}));
    }
    for (const Cube& cube : cubes) cubes_[cube].push_back({a, b});
  }
  std::map<Cube, std::vector<std::pair<Point, Point>>> cubes_;
};

}  // namespace

namespace {

using FarFromSurface = std::function<bool(Coord3)>;

std::string fault(const Mesh& before, const Mesh& after, const FarFromSurface& is_far) {
  const auto tets = numbers_of(after);
  if (numbers_of(before) != tets) return "tetrahedra have other points";
  if (!std::ranges::equal(before.labels, after.labels)) return "labels have changed";
  const certet::AngleBounds bounds = certet::bounds_of(after.method, false);
  const exact::AngleRange range(bounds.min_dihedral, bounds.max_dihedral);
  for (const auto& [a, b, c, d] : tets) {
    const exact::Tet tet{after.points[a], after.points[b], after.points[c], after.points[d]};
    if (exact::six_volume(tet) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(tet))
      if (!range.contains(angle)) return "an angle is out of bounds";
  }
  std::set<std::uint64_t> surface;
  for (const auto& face : boundary_of(after)) surface.insert(face.begin(), face.end());
  for (const std::uint64_t v : surface)
    if (before.points[v] != after.points[v] && is_far(after.points[v]))
      return "point " + std::to_string(v) + " is off the surface";
  return "";
}

}  // namespace

std::string fault(const Mesh& before, const Mesh& after, const certet::Features& features) {
  return fault(before, after, [&](Coord3 place) {
    double least = 1e9;
    for (const auto& triangle : features.triangles)
      least = std::min(least, from_triangle(in_doubles(place), triangle));
    return least > 2;
  });
}

std::string fault(const Mesh& before, const Mesh& after,
                  const std::function<double(certet::Point3)>& distance, double steps) {
  const double step = after.frame.size / (2 * certet::steps);
  return fault(before, after, [&](Coord3 place) {
    return std::fabs(distance(after.frame.world(place))) > steps * step;
  });
}

Nearness nearness(const Mesh& mesh, const certet::Features& features) {
  const Edges edges(mesh);
  Nearness found;
  double length = 0, near = 0;
  for (const certet::FeatureEdge& edge : features.edges) {
    const Point a = in_doubles(edge.from), b = in_doubles(edge.to);
    const double whole = size(minus(b, a)) / long_edge, parts = std::ceil(32 * whole);
    for (double i = 0; i < parts; ++i) {
      const double share = (i + 0.5) / parts;
      const double away = edges.nearest({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                                         a[2] + share * (b[2] - a[2])});
      found.greatest = std::max(found.greatest, away);
      length += whole / parts;
      near += away <= 0.02 ? whole / parts : 0;
    }
  }
  found.share = near / length;
  std::set<Coord3> places;
  for (const auto& face : boundary_of(mesh))
    for (const std::uint64_t v : face) places.insert(mesh.points[v]);
  for (const Coord3 corner : features.corners) found.corners += places.count(corner);
  return found;
}

double volume(const Mesh& mesh) {
  long double sum = 0;
  for (const auto& [a, b, c, d] : numbers_of(mesh))
    sum += static_cast<long double>(
        exact::six_volume({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]}));
  const long double unit = mesh.frame.size / (2.0L * certet::steps);
  return static_cast<double>(sum / 6 * unit * unit * unit);
}

}  // namespace judge
