#include "surface_faults.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "faces.hpp"
#include "groups.hpp"

namespace certet::core {
namespace {

/// What a triangle is seen as from one of its corners: a step from one neighbour to
/// another.
struct FanStep {
  std::uint64_t from, to;
  friend auto operator<=>(const FanStep&, const FanStep&) = default;
};

/// Whether the steps, sorted, go once around.
bool is_closed_fan(std::span<const FanStep> steps) {
  std::uint64_t at = steps.front().from;
  for (std::size_t gone = 1; gone <= steps.size(); ++gone) {
    const auto next = std::ranges::lower_bound(steps, at, {}, &FanStep::from);
    if (next == steps.end() || next->from != at) return false;
    at = next->to;
    if (at == steps.front().from) return gone == steps.size();
  }
  return false;
}

Point3 middle_of(const Point3& a, const Point3& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

/// The edges to higher points that are in more than two triangles.
void add_overfull_edges(std::uint64_t vertex, std::span<const FanStep> steps,
                        std::span<const Point3> points, SurfaceFaults& faults) {
  std::vector<std::uint64_t> ends;
  for (const FanStep& step : steps) ends.insert(ends.end(), {step.from, step.to});
  std::ranges::sort(ends);
  for_runs(std::span(ends), std::equal_to<>(), [&](std::span<std::uint64_t> run) {
    if (run.size() <= 2 || run.front() < vertex) return;
    ++faults.edges;
    if (faults.edge_places.size() < most_places)
      faults.edge_places.push_back(middle_of(points[vertex], points[run.front()]));
  });
}

}  // namespace

SurfaceFaults find_surface_faults(std::span<const Triangle> surface,
                                  std::span<const Point3> points, Context& context) {
  SurfaceFaults faults;
  Groups<FanStep> fans(points.size());
  for (const Triangle& triangle : surface)
    for (const std::uint64_t point : triangle) fans.count(point);
  fans.lay_out();
  for (const auto& [a, b, c] : surface) {
    fans.place(a, {b, c});
    fans.place(b, {c, a});
    fans.place(c, {a, b});
  }
  for (std::size_t vertex = 0; vertex < fans.size(); ++vertex) {
    stop_now_and_then(vertex, context);
    const std::span<FanStep> fan = fans[vertex];
    if (fan.empty()) continue;
    sort_group(fan);
    if (is_closed_fan(fan)) continue;
    ++faults.vertices;
    if (faults.vertex_places.size() < most_places) faults.vertex_places.push_back(points[vertex]);
    add_overfull_edges(vertex, fan, points, faults);
  }
  return faults;
}

}  // namespace certet::core
