#include "labelled_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "disjoint_sets.hpp"

namespace labelled {
namespace {

Triangle from_lowest(Triangle t) {
  std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  return t;
}

using Corner = std::pair<std::uint32_t, std::size_t>;  ///< a point, of which triangle

/// How many fans the triangles make around each point.
std::map<std::uint32_t, int> fans_of(
    const std::vector<Triangle>& surface,
    const std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>>& edges) {
  std::map<Corner, std::size_t> numbers;
  for (std::size_t n = 0; n < surface.size(); ++n)
    for (const std::uint32_t p : surface[n]) numbers.emplace(Corner{p, n}, numbers.size());
  DisjointSets sets(numbers.size());
  for (const auto& [edge, triangles] : edges)
    for (const std::uint32_t p : edge)
      for (const std::size_t n : triangles)
        sets.join(numbers.at({p, n}), numbers.at({p, triangles.front()}));
  std::map<std::uint32_t, int> fans;
  for (const auto& [corner, number] : numbers) fans[corner.first] += sets.root(number) == number;
  return fans;
}

}  // namespace

settling::Tets region_of(const LabelledMesh& mesh, const std::set<std::int32_t>& labels) {
  settling::Tets region;
  region.points = mesh.points;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (labels.contains(mesh.labels[t])) region.tets.push_back(mesh.tets[t]);
  return region;
}

std::vector<Triangle> surface_of(const std::vector<Tet>& tets) {
  std::vector<std::pair<Triangle, Triangle>> faces;  // sorted, and as it is seen
  for (const auto& [a, b, c, d] : tets)
    for (const Triangle& seen : {Triangle{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}) {
      Triangle sorted = seen;
      std::ranges::sort(sorted);
      faces.emplace_back(sorted, from_lowest(seen));
    }
  std::ranges::sort(faces);
  std::vector<Triangle> surface;
  topology::for_each_single(faces, [&](const Triangle&, const Triangle& seen) { surface.push_back(seen); });
  return surface;
}

SurfaceCounts counts_of(const std::vector<Triangle>& surface) {
  std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> edges;
  std::map<std::array<std::uint32_t, 2>, int> turns;
  for (std::size_t n = 0; n < surface.size(); ++n)
    for (std::size_t v = 0; v < 3; ++v) {
      const std::uint32_t from = surface[n][v], to = surface[n][(v + 1) % 3];
      const std::array<std::uint32_t, 2> edge{std::min(from, to), std::max(from, to)};
      edges[edge].push_back(n);
      turns[edge] += from < to ? 1 : -1;
    }
  SurfaceCounts counts;
  for (const auto& [edge, triangles] : edges) {
    counts.open_edges += turns.at(edge) != 0;
    counts.crowded_edges += triangles.size() > 2;
  }
  for (const auto& [point, fans] : fans_of(surface, edges))
    if (fans > 1) counts.pinched.insert(point);
  return counts;
}

exact::Wide six_volume_within(const LabelledMesh& mesh, const std::vector<Triangle>& surface) {
  exact::Wide sum = 0;
  for (const auto& [a, b, c] : surface)
    sum += exact::six_volume({Coord3{0, 0, 0}, mesh.points[a], mesh.points[b], mesh.points[c]});
  return sum;
}

}  // namespace labelled
