#include "sites.hpp"

#include <algorithm>

namespace certet::features {
namespace {

distance::TriangleTree tree_of(const Features& features, const std::vector<std::uint32_t>& chosen) {
  std::vector<Vector> points;
  std::vector<distance::Triangle> triangles;
  for (const std::uint32_t t : chosen) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Coord3 corner : features.triangles[t]) points.push_back(in_doubles(corner));
    triangles.push_back({first, first + 1, first + 2});
  }
  return {std::move(points), std::move(triangles)};
}

std::vector<std::uint32_t> all_of(const Features& features) {
  std::vector<std::uint32_t> all(features.triangles.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  return all;
}

}  // namespace

TrianglePatches::TrianglePatches(const Features& features)
    : of_(features.patches), all_(tree_of(features, all_of(features))) {
  const std::uint32_t count = *std::ranges::max_element(of_) + 1;
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::uint32_t t = 0; t < of_.size(); ++t) members[of_[t]].push_back(t);
  for (const auto& triangles : members) each_.push_back(tree_of(features, triangles));
}

std::uint32_t TrianglePatches::at(std::uint64_t, const Vector& place) const {
  return of_[all_.nearest(place).triangle];
}

Vector TrianglePatches::nearest(std::uint32_t patch, const Vector& point) const {
  const distance::TriangleTree& tree = each_[patch];
  return distance::nearest_on(tree.corners(tree.nearest(point).triangle), point);
}

Vector TrianglePatches::normal(std::uint32_t patch, const Vector& point) const {
  const distance::TriangleTree& tree = each_[patch];
  const auto& [a, b, c] = tree.corners(tree.nearest(point).triangle);
  const Vector n = cross(b - a, c - a);
  const double size = length(n);
  return size > 0 ? (1 / size) * n : Vector{0, 0, 0};
}

Sites::Sites(const Zone& zone, const Patches& patches, const std::vector<Curve>& curves)
    : patches_(patches), curves_(curves), sites_(zone.size()) {
  for (Number v = 0; v < zone.size(); ++v) {
    if (!zone.is_free(v)) continue;
    if (zone.on_surface(v))
      sites_[v] = {Role::face, patches.at(zone.in_mesh(v), in_doubles(zone.place(v)))};
    else
      sites_[v] = {Role::inside, none};
  }
}

Coord3 Sites::onto(const Site& site, const Vector& point) const {
  switch (site.role) {
    case Role::face: return in_steps(patches_.nearest(site.which, point));
    case Role::curve: return in_steps(curves_[site.which].nearest(point).place);
    default: return in_steps(point);
  }
}

Vector Sites::part_of(const Site& site, const Vector& direction, const Vector& place) const {
  switch (site.role) {
    case Role::inside: return direction;
    case Role::face: {
      const Vector normal = patches_.normal(site.which, place);
      return direction - dot(direction, normal) * normal;
    }
    case Role::curve: {
      const Curve& curve = curves_[site.which];
      const Vector along = curve.direction(curve.nearest(place).at);
      return dot(direction, along) * along;
    }
    case Role::fixed: break;
  }
  return {0, 0, 0};
}

}  // namespace certet::features
