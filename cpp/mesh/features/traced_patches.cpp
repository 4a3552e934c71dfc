#include "traced_patches.hpp"

#include <algorithm>
#include <utility>

namespace certet::features {
namespace {

/// Of points, or of segments.
distance::TriangleTree tree_of(std::vector<Vector> points, std::uint32_t ends) {
  std::vector<distance::Triangle> parts;
  for (std::uint32_t first = 0; first + ends <= points.size(); first += ends)
    parts.push_back({first, first + ends - 1, first + ends - 1});
  return {std::move(points), std::move(parts)};
}

}  // namespace

TracedPatches::TracedPatches(const Traced& traced, const Domain& domain)
    : surface_(traced.surface), of_(traced.patches), domain_(domain),
      patches_(*std::ranges::max_element(of_) + 1) {
  for (std::uint32_t v = 0; v < of_.size(); ++v) patches_[of_[v]].vertices.push_back(v);
  for (const PatchBorder& border : traced.borders) {
    Patch& patch = patches_[border.patch];
    patch.borders.push_back(border);
    for (const Vector& end : {border.from, border.to}) {
      Vector& into = patch.into.try_emplace(in_steps(end), Vector{0, 0, 0}).first->second;
      into = into + border.into;
    }
  }
  for (Patch& patch : patches_) {
    std::vector<Vector> places, ends;
    for (const std::uint32_t v : patch.vertices) places.push_back(surface_.places[v]);
    if (!places.empty()) patch.vertex_tree = tree_of(std::move(places), 1);
    for (const PatchBorder& border : patch.borders)
      ends.insert(ends.end(), {border.from, border.to});
    if (!ends.empty()) patch.border_tree = tree_of(std::move(ends), 2);
  }
}

std::uint32_t TracedPatches::at(std::uint64_t vertex, const Vector&) const {
  return of_[surface_.number_of(vertex)];
}

std::uint32_t TracedPatches::vertex_near(std::uint32_t patch, const Vector& point) const {
  const Patch& own = patches_[patch];
  return own.vertices[own.vertex_tree->nearest(point).triangle];
}

std::optional<TracedPatches::Edge> TracedPatches::edge_near(const Patch& patch,
                                                            const Vector& point) const {
  constexpr double reach = 2 * long_edge, at_end = 4;
  if (!patch.border_tree) return std::nullopt;
  const distance::Nearest found = patch.border_tree->nearest(point);
  if (found.square > reach * reach) return std::nullopt;
  const PatchBorder& border = patch.borders[found.triangle];
  Edge edge{distance::nearest_on(patch.border_tree->corners(found.triangle), point), border.into,
            std::sqrt(found.square)};
  // Between two parts of an edge, or in a corner, both count.
  for (const Vector& end : {border.from, border.to})
    if (length(edge.place - end) < at_end) edge.into = patch.into.at(in_steps(end));
  return edge;
}

Vector TracedPatches::nearest(std::uint32_t patch, const Vector& point) const {
  constexpr double reach = 0.75 * long_edge;
  const auto is_beyond = [](const Edge& edge, const Vector& p) {
    return dot(p - edge.place, edge.into) < 0;
  };
  std::optional<Edge> edge = edge_near(patches_[patch], point);
  if (edge && is_beyond(*edge, point)) return edge->place;
  const std::uint32_t vertex = vertex_near(patch, point);
  const Hit hit = cast(domain_, {point, surface_.normals[vertex], reach});
  if (!hit.found) return edge ? edge->place : surface_.places[vertex];
  edge = edge_near(patches_[patch], hit.place);
  return edge && is_beyond(*edge, hit.place) ? edge->place : hit.place;
}

Vector TracedPatches::normal(std::uint32_t patch, const Vector& point) const {
  return surface_.normals[vertex_near(patch, point)];
}

}  // namespace certet::features
