#include "plain_pieces.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace plain {
namespace {

using Three = std::array<std::uint64_t, 3>;

std::array<Three, 4> faces_of(Four tet) {
  std::ranges::sort(tet);
  const auto [a, b, c, d] = tet;
  return {{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}};
}

/// What tetrahedra are joined by: faces, or points.
std::vector<std::vector<std::uint64_t>> joints(const Four& tet, std::size_t points) {
  std::vector<std::vector<std::uint64_t>> all;
  if (points == 3)
    for (const Three& face : faces_of(tet)) all.emplace_back(face.begin(), face.end());
  else
    for (const std::uint64_t point : tet) all.push_back({point});
  return all;
}

}  // namespace

std::vector<std::vector<std::size_t>> pieces(const Mesh& mesh, std::size_t points,
                                             std::optional<std::int32_t> label) {
  std::map<std::vector<std::uint64_t>, std::vector<std::size_t>> sharing;
  const auto is_meant = [&](std::size_t n) { return !label || mesh.labels[n] == *label; };
  for (std::size_t n = 0; n < mesh.tets.size(); ++n)
    if (is_meant(n))
      for (const auto& joint : joints(mesh.tets[n], points)) sharing[joint].push_back(n);
  std::vector<bool> seen(mesh.tets.size());
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start] || !is_meant(start)) continue;
    std::vector<std::size_t> piece{start};
    seen[start] = true;
    for (std::size_t at = 0; at < piece.size(); ++at)
      for (const auto& joint : joints(mesh.tets[piece[at]], points)) {
        std::vector<std::size_t>& others = sharing[joint];
        for (const std::size_t next : others)
          if (!seen[next]) {
            seen[next] = true;
            piece.push_back(next);
          }
        others.clear();
      }
    std::ranges::sort(piece);
    all.push_back(piece);
  }
  return all;
}

std::vector<Two> sharing_tets(const Mesh& mesh) {
  std::map<Three, std::vector<std::uint64_t>> sharing;
  for (std::size_t n = 0; n < mesh.tets.size(); ++n)
    for (const Three& face : faces_of(mesh.tets[n])) sharing[face].push_back(n);
  std::vector<Two> pairs;
  for (const auto& [face, tets] : sharing)
    if (tets.size() == 2) pairs.push_back({tets[0], tets[1]});
  std::ranges::sort(pairs);
  return pairs;
}

Faults faults(const Mesh& mesh) {
  std::map<Three, int> faces;
  for (const Four& tet : mesh.tets)
    for (const Three& face : faces_of(tet)) ++faces[face];
  std::map<Two, int> edges;
  std::map<std::uint64_t, std::map<std::uint64_t, std::vector<std::uint64_t>>> links;
  for (const auto& [face, count] : faces) {
    if (count != 1) continue;
    const auto [a, b, c] = face;
    for (const Two& edge : {Two{a, b}, Two{a, c}, Two{b, c}}) ++edges[edge];
    for (const auto& [v, p, q] : {std::tuple(a, b, c), std::tuple(b, a, c), std::tuple(c, a, b)}) {
      links[v][p].push_back(q);
      links[v][q].push_back(p);
    }
  }
  Faults found;
  for (const auto& [edge, count] : edges)
    if (count > 2) found.edges.insert(edge);
  for (const auto& [v, link] : links) {
    std::set<std::uint64_t> reached{link.begin()->first};
    std::vector<std::uint64_t> open{link.begin()->first};
    bool circle = true;
    while (!open.empty()) {
      const auto& next = link.at(open.back());
      open.pop_back();
      circle &= next.size() == 2;
      for (const std::uint64_t p : next)
        if (reached.insert(p).second) open.push_back(p);
    }
    if (!circle || reached.size() != link.size()) found.vertices.insert(v);
  }
  return found;
}

certet::Pieces count(const Mesh& mesh) {
  certet::Pieces found;
  const auto by_faces = pieces(mesh, 3);
  found.whole = {by_faces.size(), pieces(mesh, 1).size()};
  for (const auto& piece : by_faces) found.largest = std::max(found.largest, piece.size());
  for (const std::int32_t label : std::set(mesh.labels.begin(), mesh.labels.end()))
    found.regions.push_back(
        {label, {pieces(mesh, 3, label).size(), pieces(mesh, 1, label).size()}});
  const auto [edges, vertices] = faults(mesh);
  certet::SurfaceFaults& surface = found.surface;
  surface.edges = edges.size();
  surface.vertices = vertices.size();
  for (const Two& edge : edges) {
    if (surface.edge_places.size() == certet::most_places) break;
    const certet::Point3 &a = mesh.points[edge[0]], &b = mesh.points[edge[1]];
    surface.edge_places.push_back(
        {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])});
  }
  for (const std::uint64_t v : vertices)
    if (surface.vertex_places.size() < certet::most_places)
      surface.vertex_places.push_back(mesh.points[v]);
  return found;
}

}  // namespace plain
