#include "certet/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>
#include <variant>
#include <vector>

#include "certet/error.hpp"
#include "crossing.hpp"
#include "engine/parallel.hpp"
#include "guard.hpp"
#include "surface_edges.hpp"

namespace certet {
namespace {

using namespace quadratic;

constexpr std::size_t edges_at_once = 512;
constexpr std::int64_t tets_at_once = 1 << 16;

/// Which middle nodes and points are those of the surfaces.
class SurfaceMarks {
 public:
  SurfaceMarks(const std::vector<SurfaceTriangle>& triangles, const MiddleNodes& middles)
      : middles_(middles), points_(middles.corners()), nodes_(middles.count()) {
    for (const SurfaceTriangle& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint64_t a = triangle.points[i], b = triangle.points[(i + 1) % 3];
        points_[a] = true;
        nodes_[middles.between(a, b)] = true;
      }
  }

  /// Puts those elements that have an edge on a surface behind `out`.
  template <class Index>
  void gather(std::span<const Tet<Index>> tets, std::uint64_t first_point,
              std::span<const Coord3> points, std::vector<SurfaceElement>& out,
              std::vector<SurfacePoints::Point>& places) const {
    for (const Tet<Index>& tet : tets) {
      const auto count = std::ranges::count_if(tet, [&](Index p) { return points_[p]; });
      if (count < 2) continue;
      SurfaceElement element{middles_.of(tet), {}};
      if (std::ranges::none_of(element.nodes, [&](std::uint64_t n) { return nodes_[n]; }))
        continue;
      for (std::size_t v = 0; v < 4; ++v) {
        element.corners[v] = points[tet[v] - first_point];
        if (points_[tet[v]]) places.emplace_back(tet[v], element.corners[v]);
      }
      out.push_back(element);
    }
    const auto lower = [](const auto& p, const auto& q) { return p.first < q.first; };
    const auto same = [](const auto& p, const auto& q) { return p.first == q.first; };
    std::sort(places.begin(), places.end(), lower);
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
  }

 private:
  const MiddleNodes& middles_;
  std::vector<bool> points_, nodes_;
};

/// The elements at the surfaces, and where the points of those are.
struct AtSurface {
  std::vector<SurfaceElement> elements;
  std::vector<SurfacePoints::Point> places;
};

/// Calls gather(task, part) for parts of a mesh, side by side, and joins the parts in order.
template <class Gather>
AtSurface gathered(std::int64_t tasks, Context& context, const Gather& gather) {
  std::vector<AtSurface> parts(static_cast<std::size_t>(tasks));
  core::parallel_for(context, Stage::emit, tasks, [&](std::int64_t task) {
    gather(task, parts[static_cast<std::size_t>(task)]);
  });
  AtSurface all;
  for (AtSurface& part : parts) {
    all.elements.insert(all.elements.end(), part.elements.begin(), part.elements.end());
    all.places.insert(all.places.end(), part.places.begin(), part.places.end());
    part = {};
  }
  std::sort(all.places.begin(), all.places.end(),
            [](const auto& p, const auto& q) { return p.first < q.first; });
  return all;
}

template <class Index>
AtSurface gathered_of(const Stuffing& stuffing, const SurfaceMarks& marks, Context& context) {
  return gathered(stuffing.layers(), context, [&](std::int64_t task, AtSurface& part) {
    const auto layer = static_cast<std::int32_t>(task);
    const std::int32_t behind = stuffing.points_end(layer + 1);
    const std::uint64_t first = stuffing.first_point(layer);
    core::OneThread own;
    Buffer<Tet<Index>> tets(stuffing.first_tet(layer + 1) - stuffing.first_tet(layer));
    Buffer<Coord3> points(stuffing.first_point(behind) - first);
    stuffing.emit_tets(layer, layer + 1, std::span<Tet<Index>>(tets), own);
    stuffing.emit_points(layer, behind, points, own);
    marks.gather(std::span<const Tet<Index>>(tets), first, std::span<const Coord3>(points),
                 part.elements, part.places);
  });
}

AtSurface gathered_of(const Mesh& mesh, const SurfaceMarks& marks, Context& context) {
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& buffer) {
        const std::span<const Tet<Index>> tets = buffer;
        const auto all = static_cast<std::int64_t>(tets.size());
        const std::int64_t tasks = (all + tets_at_once - 1) / tets_at_once;
        return gathered(tasks, context, [&](std::int64_t task, AtSurface& part) {
          const std::int64_t from = task * tets_at_once;
          marks.gather(tets.subspan(static_cast<std::size_t>(from),
                                    static_cast<std::size_t>(std::min(tets_at_once, all - from))),
                       0, std::span<const Coord3>(mesh.points), part.elements, part.places);
        });
      },
      mesh.tets);
}

std::vector<Crossing> crossings_of(std::span<const SurfaceEdge> edges, const Domain& domain,
                                   Context& context) {
  std::vector<Crossing> found(edges.size());
  const std::size_t tasks = (edges.size() + edges_at_once - 1) / edges_at_once;
  core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(tasks),
                     [&](std::int64_t task) {
                       const auto from = static_cast<std::size_t>(task) * edges_at_once;
                       const std::size_t count = std::min(edges_at_once, edges.size() - from);
                       find_crossings(edges.subspan(from, count), domain,
                                      std::span(found).subspan(from, count));
                     });
  return found;
}

double length_in_edges(Coord3 bend) {
  return std::hypot(bend.x, bend.y, bend.z) / (4.0 * steps);
}

CurveFigures curve_edges(MiddleNodes& middles, std::vector<SurfaceEdge> edges,
                         std::span<const SurfaceElement> elements, const Domain& domain,
                         Context& context) {
  CurveFigures figures;
  figures.edges = edges.size();
  figures.seams = static_cast<std::uint64_t>(
      std::erase_if(edges, [](const SurfaceEdge& edge) { return edge.seam; }));
  const std::vector<Crossing> found = crossings_of(edges, domain, context);
  std::vector<Bend> bends;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    figures.on_surface += found[i].found == Found::on_surface;
    figures.far += found[i].found == Found::far;
    if (found[i].found == Found::moved) bends.push_back({edges[i].node, found[i].bend});
  }
  const std::size_t wanted = bends.size();
  figures.least_jacobian = take_back_spoiling(elements, bends, context);
  figures.moved = bends.size();
  figures.guarded = wanted - bends.size();
  for (const Bend& bend : bends)
    figures.greatest_move = std::max(figures.greatest_move, length_in_edges(bend.by));
  middles.set_bends(std::move(bends));
  return figures;
}

template <class Gather>
CurveFigures curve_all(MiddleNodes& middles, Method method, const Survey& found,
                       const Domain& domain, Context& context, const Gather& gather) {
  if (facts(method).cuts == Cuts::midpoint)
    throw Error(ErrorCode::bad_option,
                "middle nodes cannot be put on a surface that passes the middles of edges");
  try {
    const std::vector<SurfaceTriangle> triangles = surface_triangles(found);
    AtSurface at = gather(SurfaceMarks(triangles, middles));
    const SurfacePoints points(std::move(at.places));
    return curve_edges(middles, surface_edges(triangles, middles, points), at.elements, domain,
                       context);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory for the elements at the surface");
  }
}

}  // namespace

CurveFigures curve(MiddleNodes& middles, const Mesh& mesh, const Survey& found,
                   const Domain& domain, Context& context) {
  return curve_all(middles, mesh.method, found, domain, context,
                   [&](const SurfaceMarks& marks) { return gathered_of(mesh, marks, context); });
}

CurveFigures curve(MiddleNodes& middles, const Stuffing& stuffing, const Survey& found,
                   const Domain& domain, Context& context) {
  return curve_all(middles, stuffing.method(), found, domain, context,
                   [&](const SurfaceMarks& marks) {
                     return stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max()
                                ? gathered_of<std::uint32_t>(stuffing, marks, context)
                                : gathered_of<std::uint64_t>(stuffing, marks, context);
                   });
}

}  // namespace certet
