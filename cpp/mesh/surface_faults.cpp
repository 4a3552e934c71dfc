#include "surface_faults.hpp"

#include <algorithm>
#include <utility>

#include "faces.hpp"
#include "fans.hpp"
#include "ranges.hpp"

namespace certet::core {
namespace {

constexpr std::uint32_t outer_sheet = 0, first_region = 1;
constexpr std::size_t vertices_per_task = std::size_t{1} << 15;

Point3 middle_of(const Point3& a, const Point3& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

/// What is found around some vertices.
struct Found {
  SurfaceFaults outer;
  std::vector<SheetFaults> sheets;
};

void append_places(std::vector<Point3>& places, const std::vector<Point3>& more) {
  for (const Point3& place : more)
    if (places.size() < most_places) places.push_back(place);
}

/// Surfaces are numbered: the outer one, those of the regions, the interfaces.
class Surfaces {
 public:
  Surfaces(const Survey& survey, std::span<const FacePoints> misoriented,
           std::span<const Point3> points)
      : survey_(survey), misoriented_(misoriented), points_(points), fans_(points.size()),
        first_interface_(first_region + static_cast<std::uint32_t>(survey.regions.size())) {
    for_each_triangle([this](std::uint32_t, const FacePoints& triangle) {
      for (const std::uint64_t point : triangle) fans_.count(point);
    });
    fans_.lay_out();
    for_each_triangle([this](std::uint32_t sheet, const FacePoints& triangle) {
      const auto& [a, b, c] = triangle;
      fans_.place(a, {sheet, b, c});
      fans_.place(b, {sheet, c, a});
      fans_.place(c, {sheet, a, b});
    });
  }

  [[nodiscard]] std::size_t sheets() const { return first_interface_ + survey_.interfaces.size(); }

  Found look_around(std::size_t begin, std::size_t end) {
    Found found;
    found.sheets.resize(sheets());
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      const std::span<FanStep> steps = fans_[vertex];
      sort_group(steps);
      for_runs(steps, [](const FanStep& a, const FanStep& b) { return a.sheet == b.sheet; },
               [&](std::span<FanStep> run) { look_at(vertex, run, steps, found); });
    }
    return found;
  }

 private:
  template <class Visit>
  void for_each_triangle(const Visit& visit) const {
    for (const BoundaryFace& face : survey_.boundary) {
      visit(outer_sheet, face.points);
      if (!survey_.regions.empty()) visit(sheet_of(face.label), face.points);
    }
    std::uint32_t number = first_interface_;
    for (const Interface& interface : survey_.interfaces) {
      const auto [lesser, greater] = interface.labels;
      for (const BoundaryFace& face : interface.faces) {
        const auto [a, b, c] = face.points;
        visit(sheet_of(lesser), face.points);
        const bool turned = !std::ranges::binary_search(misoriented_, face.points);
        visit(sheet_of(greater), turned ? FacePoints{a, c, b} : face.points);
        visit(number, face.points);
      }
      ++number;
    }
  }

  [[nodiscard]] std::uint32_t sheet_of(std::int32_t label) const {
    const auto region = std::ranges::lower_bound(survey_.regions, label, {}, &Region::label);
    return first_region + static_cast<std::uint32_t>(region - survey_.regions.begin());
  }

  /// The steps of one sheet, of all.
  void look_at(std::size_t vertex, std::span<const FanStep> run, std::span<const FanStep> steps,
               Found& found) const {
    const std::uint32_t sheet = run.front().sheet;
    const bool interface = sheet >= first_interface_;
    if (is_closed_fan(run)) return;
    SheetFaults& faults = found.sheets[sheet];
    const bool odd = !interface || !is_open_fan(run);
    if (odd) ++faults.odd_vertices;
    if (sheet == outer_sheet) append_places(found.outer.vertex_places, {points_[vertex]});
    for_edges(vertex, run, [&](const FanEdge& edge) {
      if (edge.forwards != edge.backwards) ++faults.open_edges;
      if (edge.triangles() > 2) ++faults.overfull_edges;
      if (edge.triangles() > 2 && sheet == outer_sheet)
        append_places(found.outer.edge_places, {middle_of(points_[vertex], points_[edge.end])});
      if (!interface || edge.triangles() % 2 == 0) return;
      ++faults.border_edges;
      if (regions_at(edge.end, steps) < 3) ++faults.loose_edges;
    });
  }

  /// How many regions' surfaces have an edge, the outside being one.
  [[nodiscard]] std::size_t regions_at(std::uint64_t end, std::span<const FanStep> steps) const {
    std::size_t count = 0;
    std::uint32_t last = first_interface_;
    for (const FanStep& step : steps) {
      if (step.sheet >= first_interface_) break;
      if (step.sheet == last || (step.from != end && step.to != end)) continue;
      last = step.sheet;
      ++count;
    }
    return count;
  }

  const Survey& survey_;
  std::span<const FacePoints> misoriented_;
  std::span<const Point3> points_;
  Groups<FanStep> fans_;
  std::uint32_t first_interface_;
};

}  // namespace

SheetFaults& SheetFaults::operator+=(const SheetFaults& other) {
  open_edges += other.open_edges;
  border_edges += other.border_edges;
  loose_edges += other.loose_edges;
  overfull_edges += other.overfull_edges;
  odd_vertices += other.odd_vertices;
  return *this;
}

AllSheetFaults find_sheet_faults(const Survey& survey, std::span<const FacePoints> misoriented,
                                 std::span<const Point3> points, Context& context) {
  Surfaces surfaces(survey, misoriented, points);
  const std::vector<Found> parts = in_ranges(
      points.size(), vertices_per_task, Stage::count, context,
      [&](std::size_t begin, std::size_t end) { return surfaces.look_around(begin, end); });
  std::vector<SheetFaults> all(surfaces.sheets());
  AllSheetFaults found;
  for (const Found& part : parts) {
    for (std::size_t sheet = 0; sheet < all.size(); ++sheet) all[sheet] += part.sheets[sheet];
    append_places(found.outer.edge_places, part.outer.edge_places);
    append_places(found.outer.vertex_places, part.outer.vertex_places);
  }
  found.outer.edges = all[outer_sheet].overfull_edges;
  found.outer.vertices = all[outer_sheet].odd_vertices;
  const auto regions = all.begin() + first_region;
  const auto interfaces = regions + static_cast<std::ptrdiff_t>(survey.regions.size());
  found.regions.assign(regions, interfaces);
  found.interfaces.assign(interfaces, all.end());
  return found;
}

SurfaceFaults find_surface_faults(std::span<const BoundaryFace> surface,
                                  std::span<const Point3> points, Context& context) {
  Survey survey;
  survey.boundary.assign(surface.begin(), surface.end());
  return find_sheet_faults(survey, {}, points, context).outer;
}

}  // namespace certet::core
