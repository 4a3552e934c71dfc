#include <algorithm>

#include "certet/surface.hpp"
#include "edges.hpp"
#include "holes.hpp"
#include "self_intersections.hpp"

namespace certet {
namespace {

/// Six times the enclosed volume, positive where triangles run anticlockwise
/// seen from outside.
double enclosed(const TriangleSurface& surface) {
  const Point3& origin = surface.points[surface.triangles.front()[0]];
  const auto from_origin = [&](std::uint32_t point) {
    const Point3& p = surface.points[point];
    return Point3{p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]};
  };
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const Point3 a = from_origin(t[0]), b = from_origin(t[1]), c = from_origin(t[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

void note(SurfaceDefect& defect, const TriangleSurface& surface, const SurfaceEdge& edge) {
  if (defect.count++ != 0) return;
  const Point3 &p = surface.points[edge.low], &q = surface.points[edge.high];
  for (std::size_t a = 0; a < 3; ++a) defect.first[a] = p[a] / 2 + q[a] / 2;
}

}  // namespace

bool is_closed(const TriangleSurface& surface) {
  refuse_malformed(surface);
  const auto edges = edges_of(surface);
  return std::none_of(edges.begin(), edges.end(),
                      [](const SurfaceEdge& edge) { return edge.odd(); });
}

SurfaceDefects inspect(const TriangleSurface& surface, const Context& context) {
  refuse_malformed(surface);
  SurfaceDefects defects;
  stop_if_cancelled(context);
  for (const SurfaceEdge& edge : edges_of(surface)) {
    if (edge.open()) note(defects.open_edges, surface, edge);
    if (edge.odd() && !edge.open()) note(defects.odd_edges, surface, edge);
    if (edge.overfull()) note(defects.overfull_edges, surface, edge);
    if (edge.misoriented()) note(defects.misoriented_edges, surface, edge);
  }
  if (defects.open_edges.count != 0)
    defects.holes = measure_holes(surface, hole_loops(surface));
  defects.self_intersections = find_self_intersections(surface, context);
  defects.inside_out = defects.closed() && defects.misoriented_edges.count == 0 &&
                       enclosed(surface) < 0;
  return defects;
}

}  // namespace certet
