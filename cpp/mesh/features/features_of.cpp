#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "certet/error.hpp"
#include "certet/features.hpp"
#include "engine/disjoint_sets.hpp"
#include "faceted.hpp"

namespace certet {
namespace features {
namespace {

/// Of two edges, one behind the other.
constexpr double sharp_turn = 40;

/// Consecutive numbers of the sets of triangles.
std::vector<std::uint32_t> patches_of(const Faceted& faceted, double angle) {
  DisjointSets sets(faceted.size());
  faceted.visit_edges([&](std::span<const Side> edge) {
    if (faceted.angle_at(edge) <= angle) sets.join(edge[0].triangle, edge[1].triangle);
  });
  std::vector<std::uint32_t> patches(faceted.size());
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < patches.size(); ++t)
    patches[t] = sets.find(t) == t ? count++ : patches[sets.find(t)];
  return patches;
}

FeatureEdge edge_of(const Faceted& faceted, std::span<const std::uint32_t> patches,
                    std::span<const Side> sides) {
  FeatureEdge edge{faceted.point(sides[0].low), faceted.point(sides[0].high),
                   patches[sides[0].triangle], patches[sides.back().triangle]};
  if (sides[0].backward) std::swap(edge.left, edge.right);
  return edge;
}

std::vector<Coord3> corners_of(std::span<const FeatureEdge> edges) {
  std::map<Coord3, std::vector<Coord3>> ends;
  for (const FeatureEdge& edge : edges) {
    ends[edge.from].push_back(edge.to);
    ends[edge.to].push_back(edge.from);
  }
  const double least = std::cos(sharp_turn * (std::numbers::pi / 180));
  std::vector<Coord3> corners;
  for (const auto& [point, others] : ends) {
    bool corner = others.size() != 2;
    if (!corner) {
      const auto in = between(others[0], point), out = between(point, others[1]);
      corner = dot(in, out) < least * (length(in) * length(out));
    }
    if (corner) corners.push_back(point);
  }
  return corners;
}

/// Whether all around the middle of an edge is inside.
bool is_within(const PlacedDomain& domain, const FeatureEdge& edge) {
  constexpr std::int32_t beside = 16;  // steps, beyond what rounding moves the middle by
  const Coord3 by = edge.to - edge.from;
  const Coord3 middle = edge.from + Coord3{by.x / 2, by.y / 2, by.z / 2};
  std::vector<Coord3> probes;
  for (const std::int32_t x : {-beside, beside})
    for (const std::int32_t y : {-beside, beside})
      for (const std::int32_t z : {-beside, beside}) probes.push_back(middle + Coord3{x, y, z});
  std::vector<Sign> signs(probes.size());
  domain.at(probes, signs);
  return std::ranges::all_of(signs, [](Sign sign) { return sign == Sign::plus; });
}

}  // namespace
}  // namespace features

Features features_of(std::span<const TriangleCorners> triangles, double angle) {
  using namespace features;
  if (!(angle >= 1 && angle <= 179))
    throw Error(ErrorCode::bad_option, "the angle of a sharp edge is from 1 to 179 degrees");
  const Faceted faceted(triangles);
  Features found{{triangles.begin(), triangles.end()}, patches_of(faceted, angle), {}, {}};
  faceted.visit_edges([&](std::span<const Side> edge) {
    if (faceted.angle_at(edge) > angle)
      found.edges.push_back(edge_of(faceted, found.patches, edge));
  });
  found.corners = corners_of(found.edges);
  return found;
}

Features features_of(const PlacedDomain& domain, double angle) {
  Features found = features_of(domain.facets(), angle);
  std::erase_if(found.edges,
                [&](const FeatureEdge& edge) { return features::is_within(domain, edge); });
  found.corners = features::corners_of(found.edges);
  return found;
}

Creases creases_of(std::span<const TriangleCorners> triangles) {
  using namespace features;
  constexpr double flat = 20;
  const Faceted faceted(triangles);
  double all = 0;
  Creases found;
  std::vector<std::uint32_t> sharp_at(faceted.point_count());
  faceted.visit_edges([&](std::span<const Side> edge) {
    const double angle = faceted.angle_at(edge), length = faceted.edge_length(edge[0]);
    all += length;
    if (angle <= flat) found.flat += length;
    if (angle <= usual_feature_angle) return;
    found.sharp += length;
    ++sharp_at[edge[0].low];
    ++sharp_at[edge[0].high];
  });
  if (all > 0) found.flat /= all, found.sharp /= all;
  const auto points = sharp_at.size() - static_cast<std::size_t>(std::ranges::count(sharp_at, 0U));
  if (points > 0)
    found.loose_ends =
        static_cast<double>(std::ranges::count(sharp_at, 1U)) / static_cast<double>(points);
  return found;
}

}  // namespace certet
