#include "certet/examine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "judge.hpp"
#include "mesh_faces.hpp"
#include "ranges.hpp"
#include "surface_faults.hpp"

namespace certet {
namespace {

using core::count_of;

/// Of each label, that it has tetrahedra or not.
using Qualities = std::map<std::int32_t, Quality>;

template <class Index>
bool is_valid(const Tet<Index>& tet, std::uint64_t points) {
  Tet<Index> p = tet;
  std::ranges::sort(p);
  return p[3] < points && std::ranges::adjacent_find(p) == p.end();
}

/// Measures some tetrahedra, those of a label together.
template <class Index>
Qualities measure(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                  std::span<const std::int32_t> labels) {
  std::map<std::int32_t, std::vector<Tet<Index>>> by_label;
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (is_valid(tets[i], points.size()))
      by_label[labels.empty() ? only_label : labels[i]].push_back(tets[i]);
  Qualities found;
  for (const auto& [label, some] : by_label)
    found[label] = measure_world(points, 0, std::span<const Tet<Index>>(some));
  return found;
}

template <class Index>
Qualities measure_all(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                      std::span<const std::int32_t> labels, Context& context) {
  const auto parts = core::in_ranges(
      tets.size(), core::tets_per_task, Stage::count, context,
      [&](std::size_t begin, std::size_t end) {
        return measure(points, tets.subspan(begin, end - begin),
                       labels.empty() ? labels : labels.subspan(begin, end - begin));
      });
  Qualities all;
  for (const Qualities& part : parts)
    for (const auto& [label, quality] : part) all[label] += quality;
  return all;
}

/// The boundary as the check wants it.
std::vector<core::Face> sorted_faces(std::span<const BoundaryFace> faces) {
  std::vector<core::Face> sorted;
  sorted.reserve(faces.size());
  for (const BoundaryFace& face : faces) {
    // The lowest comes first already.
    const auto [a, b, c] = face.points;
    sorted.push_back({{a, std::min(b, c), std::max(b, c)}, b > c});
  }
  return sorted;
}

double area_of(std::span<const BoundaryFace> faces, std::span<const Point3> points) {
  double area = 0;
  for (const BoundaryFace& face : faces)
    area += certet::area_of(points[face.points[0]], points[face.points[1]], points[face.points[2]]);
  return area;
}

template <class Index>
class Examiner {
 public:
  Examiner(std::span<const Point3> points, std::span<const Tet<Index>> tets,
           std::span<const std::int32_t> labels, Context& context)
      : points_(points), tets_(tets), labels_(labels), context_(context) {}

  Examination run() {
    const Qualities qualities = measure_all(points_, tets_, labels_, context_);
    core::MeshFaces faces = core::find_mesh_faces(points_.size(), tets_, labels_, context_);
    Quality whole;
    for (const auto& [label, quality] : qualities) {
      whole += quality;
      found_.survey.regions.push_back({label, {}, quality.tets});
    }
    faces.findings.boundary = sorted_faces(faces.outer);
    found_.report = core::judge(points_, tets_, faces.findings, whole, context_);
    faces.findings = {};
    found_.pieces = std::move(faces.pieces);
    found_.survey.boundary = std::move(faces.outer);
    found_.survey.interfaces = core::interfaces_of(std::move(faces.between));
    const core::AllSheetFaults faults = core::find_sheet_faults(found_.survey, faces.misoriented, points_, context_);
    found_.pieces.surface = faults.outer;
    if (!labels_.empty()) report_regions(qualities, faults.regions);
    report_interfaces(faults.interfaces);
    return std::move(found_);
  }

 private:
  void fail(std::string sentence) { found_.report.failures.push_back(std::move(sentence)); }

  void report_regions(const Qualities& qualities, std::span<const core::SheetFaults> faults) {
    for (const auto& [label, quality] : qualities) {
      const std::size_t n = found_.regions.size();
      found_.regions.push_back({label, quality, found_.pieces.regions[n].pieces, 0, 0,
                                faults[n].open_edges,
                                {faults[n].overfull_edges, faults[n].odd_vertices}});
      if (faults[n].open_edges > 0)
        fail("the surface of region " + std::to_string(label) + " is not closed and oriented at " +
             count_of(faults[n].open_edges, "edge", "edges"));
    }
    for (const BoundaryFace& face : found_.survey.boundary)
      add_area(face.label, 1,
               certet::area_of(points_[face.points[0]], points_[face.points[1]],
                               points_[face.points[2]]));
  }

  void add_area(std::int32_t label, std::uint64_t faces, double area) {
    const auto region = std::ranges::lower_bound(found_.regions, label, {}, &RegionReport::label);
    region->faces += faces;
    region->area += area;
  }

  void report_interfaces(std::span<const core::SheetFaults> faults) {
    for (const Interface& interface : found_.survey.interfaces) {
      const core::SheetFaults& own = faults[found_.interfaces.size()];
      const double area = area_of(interface.faces, points_);
      found_.interfaces.push_back({interface.labels, interface.faces.size(), area,
                                   own.border_edges, own.loose_edges,
                                   {own.overfull_edges, own.odd_vertices}});
      for (const std::int32_t label : interface.labels)
        add_area(label, interface.faces.size(), area);
      if (own.loose_edges > 0)
        fail("the interface of the regions " + std::to_string(interface.labels[0]) + " and " +
             std::to_string(interface.labels[1]) + " ends at " +
             count_of(own.loose_edges, "edge", "edges") +
             " where neither a third region nor the outside is");
    }
  }

  std::span<const Point3> points_;
  std::span<const Tet<Index>> tets_;
  std::span<const std::int32_t> labels_;
  Context& context_;
  Examination found_;
};

}  // namespace

Examination examine(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return Examiner<std::uint32_t>(points, tets, labels, context).run();
}

Examination examine(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels, Context& context) {
  return Examiner<std::uint64_t>(points, tets, labels, context).run();
}

double area_of(const Point3& a, const Point3& b, const Point3& c) {
  const auto minus = [](const Point3& p, const Point3& q) {
    return Point3{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  };
  const Point3 u = minus(b, a), v = minus(c, a);
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                          u[0] * v[1] - u[1] * v[0]);
}

}  // namespace certet
