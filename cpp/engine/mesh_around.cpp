#include "mesh_around.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "disjoint_sets.hpp"
#include "material_cells.hpp"

namespace certet::core {
namespace {

using NodeTet = std::array<MeshNode, 4>;

/// A structured tetrahedron at a vertex: which case of which cell, relative to its index.
struct CaseAt {
  Shift shift;
  std::uint8_t number;
};

/// Those at the vertices of each grid.
constexpr auto cases_at = [] {
  std::array<std::array<CaseAt, 4 * cell_tet_count / grid_count>, grid_count> at{};
  std::array<std::size_t, grid_count> count{};
  for (std::uint8_t c = 0; c < cell_tet_count; ++c)
    for (const std::uint8_t corner : cell.corner[c]) {
      const auto& [grid, s] = cell.vertices[corner];
      at[grid][count[grid]++] = {{static_cast<std::int8_t>(-s.x), static_cast<std::int8_t>(-s.y),
                                  static_cast<std::int8_t>(-s.z)},
                                 c};
    }
  return at;
}();

/// Calls visit(tet) for those of the mesh's tetrahedra in the structured ones at a vertex
/// that have the node.
template <class Visit>
void for_each_tet_at(const SignPlanes& planes, const VertexIndex& v, const MeshNode& node,
                     const Visit& visit) {
  for (const CaseAt& at : cases_at[v.grid]) {
    const int i = v.i + at.shift.x;
    const int j = v.j + at.shift.y;
    const int k = v.k + at.shift.z;
    if (j < 0 || k < 0 || i < 0) continue;
    for_each_material_tet(planes, i, j, k, [&](std::size_t c, const UnstructuredTet& tet, Material) {
      if (c != at.number) return;
      NodeTet nodes;
      for (std::size_t n = 0; n < 4; ++n) {
        const auto number = [&](std::uint8_t corner) {
          const auto& [grid, s] = cell.vertices[cell.corner[c][corner]];
          return number_of({grid, i + s.x, j + s.y, k + s.z});
        };
        const auto [low, high] = std::minmax({number(tet[n].a), number(tet[n].b)});
        nodes[n] = {low, high};
      }
      if (std::ranges::find(nodes, node) != nodes.end()) visit(nodes);
    });
  }
}

}  // namespace

BoundaryAround boundary_around(const SignPlanes& planes, const MeshNode& node) {
  std::vector<NodeTet> tets;
  for (const std::uint64_t end : node) {
    for_each_tet_at(planes, vertex_of(end), node, [&](NodeTet tet) {
      std::ranges::sort(tet);
      tets.push_back(tet);
    });
  }
  std::ranges::sort(tets);
  tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
  std::map<std::array<MeshNode, 2>, int> arcs;
  for (const NodeTet& tet : tets)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b)
        if (tet[a] != node && tet[b] != node) ++arcs[{tet[a], tet[b]}];
  std::map<MeshNode, std::uint32_t> ends;
  std::vector<int> degree;
  DisjointSets curves(0);
  const auto number = [&](const MeshNode& end) {
    const auto [at, is_new] = ends.try_emplace(end, static_cast<std::uint32_t>(ends.size()));
    if (is_new) {
      degree.push_back(0);
      curves.grow(degree.size());
    }
    return at->second;
  };
  for (const auto& [arc, count] : arcs) {
    if (count != 1) continue;
    const std::uint32_t a = number(arc[0]);
    const std::uint32_t b = number(arc[1]);
    ++degree[a], ++degree[b];
    curves.join(a, b);
  }
  BoundaryAround found;
  for (const auto& [end, n] : ends) {
    found.one_fan = found.one_fan && degree[n] == 2 && curves.find(n) == 0;
    if (degree[n] > 2) found.overfull.push_back(end);
  }
  return found;
}

}  // namespace certet::core
