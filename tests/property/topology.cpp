#include "topology.hpp"

#include <algorithm>
#include <numeric>

#include "disjoint_sets.hpp"

namespace topology {
namespace {

using settling::Tets;

using Edge = std::array<std::uint32_t, 2>;
using Tet = std::array<std::uint32_t, 4>;

template <class Simplex>
void make_unique(std::vector<Simplex>& simplices) {
  std::ranges::sort(simplices);
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

/// Vertices - edges + triangles - tetrahedra, of all faces of some tetrahedra, edges and
/// vertices that `counts` admits.
template <class Counts>
std::int64_t euler(const std::vector<Tet>& tets, const Counts& counts) {
  std::vector<std::uint32_t> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
  std::int64_t whole = 0;
  for (Tet t : tets) {
    std::ranges::sort(t);
    std::array<bool, 4> in;
    for (std::size_t n = 0; n < 4; ++n) in[n] = counts(t[n]);
    for (std::size_t a = 0; a < 4; ++a) {
      if (!in[a]) continue;
      vertices.push_back(t[a]);
      for (std::size_t b = a + 1; b < 4; ++b) {
        if (!in[b]) continue;
        edges.push_back({t[a], t[b]});
        for (std::size_t c = b + 1; c < 4; ++c)
          if (in[c]) triangles.push_back({t[a], t[b], t[c]});
      }
    }
    if (in[0] && in[1] && in[2] && in[3]) ++whole;
  }
  make_unique(vertices);
  make_unique(edges);
  make_unique(triangles);
  const auto size = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  return size(vertices) - size(edges) + size(triangles) - whole;
}

/// All faces with the tetrahedron each belongs to, sorted by face.
std::vector<std::pair<Triangle, std::size_t>> faces_of(const Tets& mesh) {
  std::vector<std::pair<Triangle, std::size_t>> faces;
  for (std::size_t n = 0; n < mesh.tets.size(); ++n)
    for (std::size_t across = 0; across < 4; ++across) {
      Triangle face;
      for (std::size_t v = 0, at = 0; v < 4; ++v)
        if (v != across) face[at++] = mesh.tets[n][v];
      std::ranges::sort(face);
      faces.emplace_back(face, n);
    }
  std::ranges::sort(faces);
  return faces;
}

}  // namespace

std::vector<Triangle> surface_of(const Tets& mesh) {
  std::vector<Triangle> surface;
  for_each_single(faces_of(mesh), [&](const Triangle& face, std::size_t) { surface.push_back(face); });
  return surface;
}

Shape of_samples(const settling::Model& model) {
  return of_samples(model.vertices(), [&](certet::Coord3 v) { return model.sampled_plus(v); });
}

Shape of_samples(const std::vector<certet::Coord3>& vertices,
                 const std::function<bool(certet::Coord3)>& sampled_plus) {
  std::map<certet::Coord3, std::uint32_t> numbers;
  for (const certet::Coord3 v : vertices)
    numbers.emplace(v, static_cast<std::uint32_t>(numbers.size()));
  const std::size_t outside = vertices.size();
  DisjointSets sets(vertices.size() + 1);
  std::vector<std::size_t> plus, rest{outside};
  std::vector<bool> is_plus(vertices.size());
  for (const certet::Coord3 v : vertices) {
    const std::uint32_t n = numbers.at(v);
    is_plus[n] = sampled_plus(v);
    (is_plus[n] ? plus : rest).push_back(n);
    for (const certet::Coord3 offset : certet::direction_offset) {
      const auto other = numbers.find(v + offset);
      if (other == numbers.end())
        sets.join(n, outside);
      else if (sampled_plus(other->first) == is_plus[n])
        sets.join(n, other->second);
    }
  }
  std::vector<Tet> tets;
  for (const certet::Coord3 v : vertices) {
    if ((v.x & 1) != 0) continue;
    for (const certet::StructuredTetShape& shape : certet::structured_tet_table) {
      Tet tet{};
      bool whole = true;
      for (std::size_t n = 0; n < 4 && whole; ++n) {
        const auto corner = numbers.find(v + shape.vertices[n]);
        whole = corner != numbers.end();
        if (whole) tet[n] = corner->second;
      }
      if (whole) tets.push_back(tet);
    }
  }
  Shape shape{sets.count(plus), 0, sets.count(rest) - 1};
  shape.tunnels = shape.pieces + shape.cavities -
                  euler(tets, [&](std::uint32_t n) { return bool{is_plus[n]}; });
  return shape;
}

Shape of_mesh(const Tets& mesh) {
  DisjointSets solid(mesh.points.size());
  std::vector<std::size_t> points;
  for (const Tet& t : mesh.tets)
    for (const std::uint32_t v : t) {
      solid.join(v, t[0]);
      points.push_back(v);
    }
  DisjointSets skin(mesh.points.size());
  std::vector<std::size_t> surface_points;
  for (const Triangle& t : surface_of(mesh))
    for (const std::uint32_t v : t) {
      skin.join(v, t[0]);
      surface_points.push_back(v);
    }
  Shape shape{solid.count(points), 0, 0};
  shape.cavities = skin.count(surface_points) - shape.pieces;
  shape.tunnels = shape.pieces + shape.cavities - euler(mesh.tets, [](auto) { return true; });
  return shape;
}

std::int64_t pieces_by_faces(const Tets& mesh) {
  DisjointSets sets(mesh.tets.size());
  const auto faces = faces_of(mesh);
  for (std::size_t n = 0; n + 1 < faces.size(); ++n)
    if (faces[n].first == faces[n + 1].first) sets.join(faces[n].second, faces[n + 1].second);
  std::vector<std::size_t> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return sets.count(all);
}

std::string surface_fault(const Tets& mesh) {
  const std::vector<Triangle> surface = surface_of(mesh);
  std::vector<std::pair<Edge, std::size_t>> sides;
  std::vector<std::pair<std::uint32_t, std::size_t>> corners;
  for (std::size_t n = 0; n < surface.size(); ++n) {
    const auto [a, b, c] = surface[n];
    for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{a, c}}) sides.emplace_back(edge, n);
    for (const std::uint32_t v : surface[n]) corners.emplace_back(v, corners.size());
  }
  std::ranges::sort(sides);
  // A corner of a triangle is joined to that of the next around the vertex.
  DisjointSets fans(corners.size());
  const auto corner = [&](std::size_t triangle, std::uint32_t v) {
    std::size_t n = 0;
    while (surface[triangle][n] != v) ++n;
    return 3 * triangle + n;
  };
  for (std::size_t n = 0; n < sides.size(); n += 2) {
    const Edge& edge = sides[n].first;
    if (n + 1 == sides.size() || sides[n + 1].first != edge ||
        (n + 2 < sides.size() && sides[n + 2].first == edge))
      return "an edge of the surface is not in two triangles";
    for (const std::uint32_t v : edge)
      fans.join(corner(sides[n].second, v), corner(sides[n + 1].second, v));
  }
  std::ranges::sort(corners);
  for (std::size_t n = 0; n + 1 < corners.size(); ++n)
    if (corners[n].first == corners[n + 1].first &&
        fans.root(corners[n].second) != fans.root(corners[n + 1].second))
      return "a vertex of the surface has several fans";
  return "";
}

}  // namespace topology
