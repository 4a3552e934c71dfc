#include "certet/distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certet/error.hpp"
#include "runs.hpp"
#include "shape_surface.hpp"
#include "triangle_tree.hpp"
#include "vectors.hpp"

namespace certet {
namespace {

using namespace distance;

/// Points at which a surface is measured, and the area that each stands for.
struct Measured {
  std::vector<Point3> points;
  std::vector<double> areas;

  void add(const Point3& point, double area) {
    points.push_back(point);
    areas.push_back(area);
  }
};

/// Vertices, edge middles and centroids, in lattice units: of each triangle for a 20th, two 15ths
/// and nine 20ths of its area.
Measured measured(const MeshSurface& surface, const Frame& frame) {
  Measured found;
  for (const Point3& point : surface.points) found.add(frame.position(point), 0);
  struct Edge {
    std::uint32_t low, high;
    double area;
  };
  std::vector<Edge> edges;
  for (const auto& [a, b, c] : surface.triangles) {
    const Point3 p = found.points[a], q = found.points[b], r = found.points[c];
    const double area = length(normal(p, q, r)) / 2;
    for (const std::uint32_t corner : {a, b, c}) found.areas[corner] += area / 20;
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges.push_back({std::min(i, j), std::max(i, j), area * 2 / 15});
    found.add(centroid(p, q, r), area * 9 / 20);
  }
  std::ranges::stable_sort(edges, {}, [](const Edge& e) { return std::pair(e.low, e.high); });
  for (auto edge = edges.begin(); edge != edges.end();) {
    const Edge first = *edge;
    double area = 0;
    for (; edge != edges.end() && edge->low == first.low && edge->high == first.high; ++edge)
      area += edge->area;
    found.add(between(found.points[first.low], found.points[first.high], 0.5), area);
  }
  return found;
}

/// From distances in lattice units; the first of the greatest.
Distance figures(const std::vector<Point3>& points, const std::vector<double>& areas,
                 const std::vector<double>& distances, const Frame& frame) {
  double squares = 0, area = 0;
  std::size_t greatest = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    squares += areas[i] * distances[i] * distances[i];
    area += areas[i];
    if (distances[i] > distances[greatest]) greatest = i;
  }
  const double unit = frame.size / 2;
  return {unit * distances[greatest], area > 0 ? unit * std::sqrt(squares / area) : 0,
          frame.world_at(points[greatest]), points.size()};
}

/// From the shape's surface to the mesh's, of which these are the points in lattice units.
Distance to_mesh(const ShapeSurface& shape, const MeshSurface& mesh,
                 std::span<const Point3> corners, const Frame& frame, Context& context) {
  const TriangleTree tree({corners.begin(), corners.end()}, mesh.triangles);
  const std::vector<ShapePoint>& points = shape.points();
  std::vector<double> distances(points.size()), areas(points.size());
  in_runs(points.size(), context, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      const Nearest nearest = tree.nearest(points[i].at);
      distances[i] = std::sqrt(nearest.square);
      areas[i] = points[i].area;
      if (points[i].axis < 0) continue;
      // Seen along its axis, the surface is as steep as the mesh is there.
      const Corners t = tree.corners(nearest.triangle);
      const Point3 n = normal(t.a, t.b, t.c);
      const double whole = length(n);
      areas[i] *= whole > 0 ? std::abs(n[static_cast<std::size_t>(points[i].axis)]) / whole : 0;
    }
  });
  std::vector<Point3> places;
  for (const ShapePoint& point : points) places.push_back(point.at);
  return figures(places, areas, distances, frame);
}

}  // namespace

DistanceFigures measure_distance(const MeshSurface& mesh, const PlacedDomain& shape,
                                 Context& context) {
  if (mesh.triangles.empty())
    throw Error(ErrorCode::empty_domain, "the mesh has no surface to measure distances from");
  return in_memory([&] {
    const Frame& frame = shape.frame();
    const Measured points = measured(mesh, frame);
    const ShapeSurface surface(shape, mesh.interfaces, context);
    DistanceFigures found;
    found.to_shape =
        figures(points.points, points.areas, surface.distances(points.points, context), frame);
    found.to_mesh = to_mesh(surface, mesh, std::span(points.points).first(mesh.points.size()),
                            frame, context);
    found.edge = frame.size;
    found.exact = surface.is_exact();
    return found;
  });
}

double mean_edge(const MeshSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      sum += length(difference(surface.points[i], surface.points[j]));
  const auto edges = 3 * static_cast<double>(surface.triangles.size());
  return edges > 0 ? sum / edges : 0;
}

DistanceFigures measure_distance(std::span<const Point3> points, const Survey& survey,
                                 const Solid& shape, double edge, Context& context) {
  MeshSurface mesh = surface_of(points, survey, false);
  const auto domain = solid_domain(shape, edge > 0 ? edge : mean_edge(mesh));
  if (domain->labels().size() > 1 && !survey.interfaces.empty())
    mesh = surface_of(points, survey, true);
  return measure_distance(mesh, *domain, context);
}

std::vector<double> distances_from(const PlacedDomain& shape, bool interfaces,
                                   std::span<const Point3> points, Context& context) {
  return in_memory([&] {
    const Frame& frame = shape.frame();
    std::vector<Point3> positions;
    for (const Point3& point : points) positions.push_back(frame.position(point));
    const ShapeSurface surface(shape, interfaces, context);
    std::vector<double> distances = surface.distances(positions, context);
    for (double& one : distances) one *= frame.size / 2;
    return distances;
  });
}

}  // namespace certet
