#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "certet/curved_quality.hpp"
#include "certet/error.hpp"
#include "certet/middle_nodes.hpp"
#include "jacobian.hpp"
#include "mesh/ranges.hpp"

namespace certet {
namespace {

using namespace quadratic;

constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t elements_at_once = 4096;

/// A part of an edge that no rounding of a file's doubles explains.
constexpr double bent_part = 1e-9;

struct Elements {
  std::span<const Point3> points;
  std::span<const Tet<std::uint64_t>> tets;
  std::span<const Point3> middle_points;
  std::span<const std::array<std::uint64_t, 6>> middles;

  [[nodiscard]] bool has_corners(std::size_t i) const {
    return std::ranges::all_of(tets[i], [&](std::uint64_t p) { return p < points.size(); });
  }
  [[nodiscard]] bool has_middles(std::size_t i) const {
    return std::ranges::all_of(middles[i],
                               [&](std::uint64_t n) { return n < middle_points.size(); });
  }
};

/// Whether a node is farther from its edge's middle than rounding explains.
bool is_bent(const Point3& a, const Point3& b, const Point3& node) {
  double aside = 0, length = 0, size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    aside = std::max(aside, std::fabs(node[axis] - 0.5 * (a[axis] + b[axis])));
    length = std::max(length, std::fabs(a[axis] - b[axis]));
    size = std::max({size, std::fabs(a[axis]), std::fabs(b[axis])});
  }
  return aside > bent_part * length + std::ldexp(size, -50);
}

/// That each edge has one middle node, and each middle node one edge.
void check_edges(const Elements& elements, CurvedQuality& found) {
  std::vector<Tet<std::uint64_t>> sound;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < elements.tets.size(); ++i)
    if (elements.has_corners(i) && elements.has_middles(i)) {
      sound.push_back(elements.tets[i]);
      numbers.push_back(i);
    }
  const MiddleNodes edges = middle_nodes(elements.points.size(), sound);
  std::vector<std::uint64_t> node_of(edges.count(), none);
  std::vector<std::uint64_t> edge_of(elements.middle_points.size(), none);
  std::vector<bool> torn(edges.count()), shared(elements.middle_points.size());
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const auto own = edges.of(sound[i]);
    for (std::size_t e = 0; e < 6; ++e) {
      const std::uint64_t node = elements.middles[numbers[i]][e];
      if (node_of[own[e]] == none) node_of[own[e]] = node;
      if (edge_of[node] == none) edge_of[node] = own[e];
      if (node_of[own[e]] != node) torn[own[e]] = true;
      if (edge_of[node] != own[e]) shared[node] = true;
    }
  }
  found.torn_edges = static_cast<std::uint64_t>(std::ranges::count(torn, true));
  found.shared_nodes = static_cast<std::uint64_t>(std::ranges::count(shared, true));
  edges.for_each(0, edges.corners(), [&](std::uint64_t edge, std::uint64_t a, std::uint64_t b) {
    found.bent += is_bent(elements.points[a], elements.points[b],
                          elements.middle_points[node_of[edge]]);
  });
}

void measure(const Elements& elements, std::size_t i, CurvedQuality& found) {
  if (!elements.has_corners(i)) return;
  if (!elements.has_middles(i)) {
    for (const std::uint64_t node : elements.middles[i])
      found.bad_indices += node >= elements.middle_points.size();
    return;
  }
  std::array<Point3, 4> corners;
  std::array<Point3, 6> middles, straight;
  for (std::size_t v = 0; v < 4; ++v) corners[v] = elements.points[elements.tets[i][v]];
  for (std::size_t e = 0; e < 6; ++e) {
    middles[e] = elements.middle_points[elements.middles[i][e]];
    for (std::size_t axis = 0; axis < 3; ++axis)
      straight[e][axis] = 0.5 * (corners[tet_edges[e][0]][axis] + corners[tet_edges[e][1]][axis]);
  }
  const auto bounds = jacobian_coefficients(doubled_points(corners, middles));
  const double whole = jacobian_coefficients(doubled_points(corners, straight))[0];
  double least = bounds[0], sum = 0;
  for (const double bound : bounds) {
    least = bound < least || std::isnan(bound) ? bound : least;
    sum += bound;
  }
  if (!(least > 0)) ++found.nonpositive;
  if (whole > 0) found.least_jacobian = std::min(found.least_jacobian, least / whole);
  // The mean of the coefficients is that of the determinant: six times six volumes.
  if (std::isfinite(sum)) found.volume += sum / 20 / 36;
}

CurvedQuality measure_all(const Elements& elements, Context& context) {
  const std::size_t all = elements.tets.size();
  const auto parts = core::in_ranges(all, elements_at_once, Stage::emit, context,
                                     [&](std::size_t begin, std::size_t end) {
                                       CurvedQuality part;
                                       for (std::size_t i = begin; i < end; ++i)
                                         measure(elements, i, part);
                                       return part;
                                     });
  CurvedQuality found;
  for (const CurvedQuality& part : parts) {
    found.bad_indices += part.bad_indices;
    found.nonpositive += part.nonpositive;
    found.least_jacobian = std::min(found.least_jacobian, part.least_jacobian);
    found.volume += part.volume;
  }
  return found;
}

void tell(CurvedQuality& found) {
  const auto say = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0)
      found.failures.push_back(std::to_string(count) + (count == 1 ? one : many));
  };
  say(found.bad_indices, " middle node is named that is not there",
      " middle nodes are named that are not there");
  say(found.nonfinite, " middle node is not finite", " middle nodes are not finite");
  say(found.torn_edges, " edge has several middle nodes", " edges have several middle nodes");
  say(found.shared_nodes, " middle node is in the middle of several edges",
      " middle nodes are in the middle of several edges");
  say(found.nonpositive,
      " curved tetrahedron has a Jacobian determinant that is not bounded above 0",
      " curved tetrahedra have Jacobian determinants that are not bounded above 0");
}

}  // namespace

CurvedQuality measure_curved(std::span<const Point3> points,
                             std::span<const Tet<std::uint64_t>> tets,
                             std::span<const Point3> middle_points,
                             std::span<const std::array<std::uint64_t, 6>> middles,
                             Context& context) {
  try {
    const Elements elements{points, tets, middle_points, middles};
    CurvedQuality found = measure_all(elements, context);
    found.nodes = middle_points.size();
    found.nonfinite = static_cast<std::uint64_t>(std::ranges::count_if(
        middle_points, [](const Point3& point) { return !is_finite(point); }));
    check_edges(elements, found);
    tell(found);
    return found;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory while looking at the middle nodes");
  }
}

}  // namespace certet
