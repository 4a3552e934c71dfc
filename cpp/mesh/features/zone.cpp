#include "zone.hpp"

#include <algorithm>
#include <unordered_set>
#include <variant>

#include "cubes.hpp"
#include "engine/border.hpp"
#include "mesh/boundary.hpp"
#include "mesh/optimise/vertex_faces.hpp"

namespace certet::features {
namespace {

/// In the order in which they follow each other, if they are a closed fan.
bool put_in_order(std::vector<std::array<Number, 2>>& fan) {
  for (std::size_t i = 1; i < fan.size(); ++i) {
    const auto next = std::find_if(fan.begin() + static_cast<std::ptrdiff_t>(i), fan.end(),
                                   [&](const auto& t) { return t[0] == fan[i - 1][1]; });
    if (next == fan.end()) return false;
    std::iter_swap(next, fan.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return fan.empty() || fan.back()[1] == fan.front()[0];
}

}  // namespace

template <class Index>
void Zone::gather(const Mesh& mesh, std::span<const Tet<Index>> tets,
                  std::span<const FeatureEdge> edges) {
  std::unordered_set<CubeKey> near;
  for (const FeatureEdge& edge : edges)
    visit_along(in_doubles(edge.from), in_doubles(edge.to), [&](CubeKey key) { near.insert(key); });
  std::vector<std::uint8_t> near_one(mesh.points.size());
  for (std::size_t v = 0; v < near_one.size(); ++v)
    near_one[v] = near.contains(cube_of(mesh.points[v]));
  std::vector<Number> own(mesh.points.size(), none);
  std::vector<std::uint64_t> chosen;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& [a, b, c, d] = tets[t];
    if ((near_one[a] | near_one[b] | near_one[c] | near_one[d]) == 0) continue;
    chosen.push_back(t);
    for (const Index v : tets[t]) own[v] = 0;
  }
  for (std::size_t v = 0; v < own.size(); ++v) {
    if (own[v] == none) continue;
    own[v] = static_cast<Number>(numbers_.size());
    numbers_.push_back(v);
    places_.push_back(mesh.points[v]);
    free_.push_back(near_one[v]);
  }
  std::vector<std::int32_t> labels;
  for (const std::uint64_t t : chosen) {
    const auto& [a, b, c, d] = tets[t];
    tets_.push_back({own[a], own[b], own[c], own[d]});
    labels.push_back(mesh.labels.empty() ? 0 : mesh.labels[t]);
  }
  origins_ = places_;
  stars_ = Stars(std::span<const Tet<Number>>(tets_), std::span<const std::uint8_t>(free_));
  find_fans(mesh, labels);
}

void Zone::find_fans(const Mesh& mesh, std::span<const std::int32_t> labels) {
  star_.resize(size());
  neighbours_.resize(size());
  fans_.resize(size());
  optimising::VertexFaces faces;
  std::vector<optimising::VertexFace> found;
  std::vector<std::uint8_t> stays(size());
  for (std::uint32_t i = 0; i < stars_.vertices().size(); ++i) {
    const auto v = static_cast<Number>(stars_.vertices()[i]);
    star_[v] = i;
    faces.start(3 * stars_.around(i).size());
    for (const StarTet at : stars_.around(i)) {
      const auto& tet = tets_[at.tet()];
      for (std::size_t opposite = 0; opposite < 4; ++opposite) {
        if (tet[opposite] != v) neighbours_[v].push_back(tet[opposite]);
        if (opposite == at.corner()) continue;
        const auto& [a, b, c] = core::outward_faces[opposite];
        const std::int32_t label = labels[at.tet()];
        if (a == at.corner()) faces.add(tet[b], tet[c], label);
        else if (b == at.corner()) faces.add(tet[c], tet[a], label);
        else faces.add(tet[a], tet[b], label);
      }
    }
    std::ranges::sort(neighbours_[v]);
    neighbours_[v].erase(std::unique(neighbours_[v].begin(), neighbours_[v].end()),
                         neighbours_[v].end());
    faces.surfaces(found);
    for (const optimising::VertexFace& face : found) {
      if (!face.outer) stays[v] = 1;
      else
        fans_[v].push_back(
            {static_cast<Number>(face.others[0]), static_cast<Number>(face.others[1])});
    }
    // Where the surface is no manifold, or that of a box that is to stay, nothing moves.
    if (!put_in_order(fans_[v])) stays[v] = 1;
    if (holds_border_ && !fans_[v].empty() && !mesh.border.empty() &&
        core::is_on_border(places_[v], mesh.border, Cuts::bisect))
      stays[v] = 1;
  }
  for (Number v = 0; v < size(); ++v) {
    if (stays[v] != 0) free_[v] = 0;
    if (is_free(v) && on_surface(v)) cubes_[cube_of(origins_[v])].push_back(v);
  }
}

std::vector<Number> Zone::near(std::span<const Vector> line) const {
  std::unordered_set<CubeKey> keys;
  visit_along(line.front(), line.front(), [&](CubeKey key) { keys.insert(key); });
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    visit_along(line[i], line[i + 1], [&](CubeKey key) { keys.insert(key); });
  std::vector<Number> found;
  for (const CubeKey key : keys)
    if (const auto cube = cubes_.find(key); cube != cubes_.end())
      found.insert(found.end(), cube->second.begin(), cube->second.end());
  std::ranges::sort(found);
  return found;
}

Zone::Zone(const Mesh& mesh, std::span<const FeatureEdge> edges, bool holds_border)
    : holds_border_(holds_border) {
  std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& tets) {
        gather(mesh, std::span<const Tet<Index>>(tets), edges);
      },
      mesh.tets);
}

bool Zone::are_neighbours(Number v, Number w) const {
  if (!is_free(v)) return is_free(w) && are_neighbours(w, v);
  return std::ranges::binary_search(neighbours_[v], w);
}

bool Zone::are_on_edge(Number v, Number w) const {
  if (!is_free(v)) return is_free(w) && are_on_edge(w, v);
  return std::ranges::any_of(fans_[v], [w](const auto& t) { return t[0] == w; });
}

}  // namespace certet::features
