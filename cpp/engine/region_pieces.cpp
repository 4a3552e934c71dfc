#include "region_pieces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "layer_loop.hpp"
#include "material_cells.hpp"
#include "mesh_around.hpp"
#include "piece_count.hpp"
#include "places.hpp"
#include "plus_runs.hpp"

namespace certet::core {
namespace {

using RunPair = std::array<std::uint32_t, 2>;
using SharedKey = std::array<std::uint64_t, 4>;

/// A long edge between two materials, from a vertex in a direction.
struct LongEdge {
  VertexIndex from;
  std::uint8_t direction;
  RunPair runs;
};

/// The neighbours of higher numbers than one.
constexpr LinkSet after(int d) {
  return whole_link & ~static_cast<LinkSet>(below(d + 1));
}

/// Joins runs, layer after layer.
class RegionJoiner {
 public:
  RegionJoiner(const RegionRuns& runs, const WarpedLattice& warped, JoinedRegions& joined)
      : runs_(runs), planes_(warped.planes), materials_(*warped.planes.materials()),
        joined_(joined) {}

  void join_rows(std::int32_t k) {
    for (std::int32_t j = 0; j < planes_.cells()[1]; ++j) {
      for (const Grid grid : grids) join_in_row(grid, j, k);
      for (const RowEdges& edges : edges_between_rows) {
        const int y = j + edges.to.shift.y;
        const int z = k + edges.to.shift.z;
        if (y >= 0 && y < planes_.cells()[1] && z < planes_.cells()[2]) join_two(edges, j, k);
      }
    }
  }

  /// Edges between materials, once those within one are joined.
  void join_across() {
    for (const auto& [a, b] : across_) joined_.by_faces.join(a, b);
    for (const LongEdge& edge : long_across_) {
      if (joined_.by_faces.find(edge.runs[0]) != joined_.by_faces.find(edge.runs[1]) &&
          share_a_face(edge))
        joined_.by_faces.join(edge.runs[0], edge.runs[1]);
    }
    joined_.by_vertices = joined_.by_faces;
    for (const LongEdge& edge : long_across_) joined_.by_vertices.join(edge.runs[0], edge.runs[1]);
  }

  /// What is around the zero vertices and long cuts of a layer, for `visit_zero(v)` and
  /// `visit_cut(v, direction)`.
  template <class VisitZero, class VisitCut>
  void visit_layer(std::int32_t k, const VisitZero& visit_zero, const VisitCut& visit_cut) const {
    for (std::int32_t j = 0; j < planes_.cells()[1]; ++j)
      for (const Grid grid : grids)
        for (int w = 0; w < planes_.words(); ++w) {
          for_each_bit(planes_.zero(grid, j, k)[w],
                       [&](int b) { visit_zero(VertexIndex{grid, 64 * w + b, j, k}); });
        }
    for (std::int32_t j = 0; j < planes_.cells()[1]; ++j)
      for (int w = 0; w < planes_.words(); ++w) {
        const auto parted = materials_.parted(j, k, w);
        for (std::size_t f = 0; f < family_count; ++f) {
          const std::uint8_t direction = family_directions[f][0];
          if (!is_long(direction)) continue;
          for_each_bit(parted[f], [&](int b) {
            const VertexIndex v{families[f].first.grid, 64 * w + b, j, k};
            const VertexIndex to = v.next(direction);
            if (is_zero(v) || is_zero(to) || (!is_plus(v) && !is_plus(to))) return;
            visit_cut(v, direction);
          });
        }
      }
  }

  [[nodiscard]] bool is_plus(const VertexIndex& v) const {
    return (planes_.plus(v.grid, v.j, v.k)[v.i >> 6] >> (v.i & 63) & 1) != 0;
  }
  [[nodiscard]] bool is_zero(const VertexIndex& v) const {
    return (planes_.zero(v.grid, v.j, v.k)[v.i >> 6] >> (v.i & 63) & 1) != 0;
  }
  /// Of a plus vertex, or the lower one of a zero one; 0 of all others.
  [[nodiscard]] Material material(const VertexIndex& v) const {
    return is_plus(v) || is_zero(v) ? materials_.at(v.grid, v.i, v.j, v.k) : 0;
  }
  [[nodiscard]] std::uint32_t run(const VertexIndex& v) const { return runs_.run_of(v); }

 private:
  void join_in_row(Grid grid, std::int32_t j, std::int32_t k) {
    const std::span<const RegionRun> row = runs_.row(grid, j, k);
    const std::uint32_t first = runs_.first(grid, j, k);
    for (std::uint32_t n = 1; n < row.size(); ++n)
      if (row[n - 1].end == row[n].begin)
        long_across_.push_back({{grid, row[n].begin - 1, j, k}, 0, {first + n - 1, first + n}});
  }

  void join_two(const RowEdges& edges, std::int32_t j, std::int32_t k) {
    const auto& [from, to] = edges;
    const int y = j + to.shift.y;
    const int z = k + to.shift.z;
    const std::span<const RegionRun> own = runs_.row(from, j, k);
    const std::span<const RegionRun> other = runs_.row(to.grid, y, z);
    const std::uint32_t first = runs_.first(from, j, k);
    const std::uint32_t other_first = runs_.first(to.grid, y, z);
    const int shift = to.shift.x;
    std::uint32_t n = 0;
    for (std::uint32_t m = 0; m < own.size(); ++m) {
      while (n < other.size() && other[n].end - shift <= own[m].begin) ++n;
      for (std::uint32_t p = n; p < other.size() && other[p].begin - shift < own[m].end; ++p)
        add({first + m, other_first + p}, from, edges,
            std::max(own[m].begin, other[p].begin - shift),
            std::min(own[m].end, other[p].end - shift), j, k);
    }
  }

  void add(const RunPair& pair, Grid from, const RowEdges& edges, std::int32_t begin,
           std::int32_t end, std::int32_t j, std::int32_t k) {
    if (runs_[pair[0]].material == runs_[pair[1]].material) {
      joined_.region_by_faces.join(pair[0], pair[1]);
      return;
    }
    if (from != edges.to.grid) {
      across_.push_back(pair);
      return;
    }
    const auto direction = direction_of(edges);
    for (std::int32_t i = begin; i < end; ++i)
      long_across_.push_back({{from, i, j, k}, direction, pair});
  }

  static std::uint8_t direction_of(const RowEdges& edges) {
    std::uint8_t d = 0;
    while (!(neighbor(edges.from, d) == edges.to)) ++d;
    return d;
  }

  /// Whether the tetrahedra at both ends of a long edge have a face in common.
  [[nodiscard]] bool share_a_face(const LongEdge& edge) const {
    LinkSet zero = 0;
    bool any_plus = false;
    const LinkSet ring = link_ring[edge.direction];
    for_each_bit(ring, [&](int d) {
      const VertexIndex v = edge.from.next(static_cast<std::size_t>(d));
      any_plus = any_plus || is_plus(v);
      if (is_zero(v)) zero |= LinkSet{1} << d;
    });
    if (any_plus) return true;
    bool next_to_each_other = false;
    for_each_bit(zero, [&](int d) {
      next_to_each_other =
          next_to_each_other || (link_ring[static_cast<std::size_t>(d)] & zero) != 0;
    });
    return next_to_each_other;
  }

  const RegionRuns& runs_;
  const SignPlanes& planes_;
  const MaterialPlanes& materials_;
  JoinedRegions& joined_;
  std::vector<RunPair> across_;
  std::vector<LongEdge> long_across_;
};

/// What zero vertices and long cuts add to edges.
class PointJoiner {
 public:
  PointJoiner(const RegionJoiner& joiner, JoinedRegions& joined)
      : joiner_(joiner), joined_(joined) {}

  /// Finds the tetrahedra of four zero vertices, by the least of them.
  void find_shared(const VertexIndex& v) {
    for_each_shared(v, [&](const SharedKey& key, const auto&) {
      if (key[0] != number_of(v)) return;
      const auto number = static_cast<std::uint32_t>(joined_.materials.size());
      if (!shared_.try_emplace(key, number).second) return;
      joined_.materials.push_back(joiner_.material(v));
      joined_.shared.push_back(
          {vertex_of(key[0]), vertex_of(key[1]), vertex_of(key[2]), vertex_of(key[3])});
      for (DisjointSets* sets : {&joined_.by_faces, &joined_.by_vertices,
                                 &joined_.region_by_faces, &joined_.region_by_vertices})
        sets->grow(joined_.materials.size());
    });
  }

  void join_faces(const VertexIndex& v) {
    const LinkSet zero = link(v).second;
    for_each_bit(zero, [&](int a) {
      for_each_bit(zero & link_ring[static_cast<std::size_t>(a)] & after(a), [&](int b) {
        const LinkSet sides =
            link_ring[static_cast<std::size_t>(a)] & link_ring[static_cast<std::size_t>(b)];
        const int one = std::countr_zero(sides);
        const int other = static_cast<int>(std::bit_width(sides)) - 1;
        const auto p = behind(v, a, b, one);
        const auto q = behind(v, a, b, other);
        if (p == none || q == none) return;
        joined_.by_faces.join(p, q);
        if (joined_.materials[p] == joined_.materials[q]) joined_.region_by_faces.join(p, q);
      });
    });
  }

  /// Once all faces are joined.
  void join_points(const VertexIndex& v) {
    std::uint32_t first = none;
    std::map<Material, std::uint32_t> by_material;
    const auto add = [&](std::uint32_t one) {
      if (first == none) first = one;
      joined_.by_vertices.join(first, one);
      const auto found = by_material.try_emplace(joined_.materials[one], one).first;
      joined_.region_by_vertices.join(found->second, one);
    };
    for_each_bit(link(v).first, [&](int d) { add(joiner_.run(v.next(static_cast<std::size_t>(d)))); });
    for_each_shared(v, [&](const SharedKey& key, const auto&) { add(shared_.at(key)); });
  }

  /// What fills the space around a long cut touches it.
  void join_around_cut(const VertexIndex& v, std::size_t direction) {
    const VertexIndex to = v.next(direction);
    const std::array<Material, 2> ends{joiner_.material(v), joiner_.material(to)};
    const LinkSet ring = link_ring[direction];
    for_each_bit(ring, [&](int d) {
      const LinkSet across = ring & ~LinkSet{link_ring[static_cast<std::size_t>(d)]} & after(d);
      if (across == 0) return;
      const VertexIndex one = v.next(static_cast<std::size_t>(d));
      const VertexIndex other = v.next(static_cast<std::size_t>(std::countr_zero(across)));
      if (!joiner_.is_plus(one) || !joiner_.is_plus(other)) return;
      const Material material = joiner_.material(one);
      if (material != joiner_.material(other) || material == ends[0] || material == ends[1]) return;
      joined_.region_by_vertices.join(joiner_.run(one), joiner_.run(other));
    });
  }

  /// Whether the surface at a zero vertex is simple without a closer look.
  [[nodiscard]] bool is_simple(const VertexIndex& v) const {
    const auto [plus, zero] = link(v);
    if (!is_strict_disk(plus, zero)) return false;
    bool any_shared = false;
    for_each_shared(v, [&](const SharedKey&, const auto&) { any_shared = true; });
    return !any_shared;
  }

  /// Whether the outside touches the cut of a long edge between two materials.
  [[nodiscard]] bool is_touched(const VertexIndex& v, std::size_t direction) const {
    if (!joiner_.is_plus(v) || !joiner_.is_plus(v.next(direction))) return false;
    int outside = 0;
    for_each_bit(LinkSet{link_ring[direction]}, [&](int d) {
      const VertexIndex at = v.next(static_cast<std::size_t>(d));
      outside += !joiner_.is_plus(at) && !joiner_.is_zero(at) ? 1 : 0;
    });
    return outside > 1;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Plus and zero neighbours.
  [[nodiscard]] std::pair<LinkSet, LinkSet> link(const VertexIndex& v) const {
    LinkSet plus = 0;
    LinkSet zero = 0;
    for (std::size_t d = 0; d < direction_count; ++d) {
      const VertexIndex to = v.next(d);
      if (joiner_.is_plus(to)) plus |= LinkSet{1} << d;
      if (joiner_.is_zero(to)) zero |= LinkSet{1} << d;
    }
    return {plus, zero};
  }

  [[nodiscard]] static SharedKey key_of(const VertexIndex& v, const std::array<int, 3>& directions) {
    SharedKey key{number_of(v)};
    for (std::size_t n = 0; n < 3; ++n)
      key[n + 1] = number_of(v.next(static_cast<std::size_t>(directions[n])));
    std::ranges::sort(key);
    return key;
  }

  /// Calls visit(key, directions) for the tetrahedra of zero vertices at one that are kept.
  template <class Visit>
  void for_each_shared(const VertexIndex& v, const Visit& visit) const {
    if (joiner_.material(v) == 0) return;
    const LinkSet zero = link(v).second;
    if (std::popcount(zero) < 3) return;
    for (const auto& [d, e, f] : link_triangles)
      if ((zero >> d & zero >> e & zero >> f & 1) != 0 && joiner_.material(v.next(d)) != 0 &&
          joiner_.material(v.next(e)) != 0 && joiner_.material(v.next(f)) != 0)
        visit(key_of(v, {d, e, f}), std::array<int, 3>{d, e, f});
  }

  /// What is at the face of a zero vertex and two of its neighbours, on the side of a third
  /// neighbour.
  [[nodiscard]] std::uint32_t behind(const VertexIndex& v, int a, int b, int side) const {
    const VertexIndex apex = v.next(static_cast<std::size_t>(side));
    if (joiner_.is_plus(apex)) return joiner_.run(apex);
    if (!joiner_.is_zero(apex)) return none;
    const auto found = shared_.find(key_of(v, {a, b, side}));
    return found == shared_.end() ? none : found->second;
  }

  const RegionJoiner& joiner_;
  JoinedRegions& joined_;
  std::map<SharedKey, std::uint32_t> shared_;
};

/// A point of the mesh by its row, its kind, and its index: as points are numbered.
using PointKey = std::array<std::int64_t, 4>;

std::size_t direction_between(const VertexIndex& v, std::uint64_t to) {
  std::size_t d = 0;
  while (number_of(v.next(d)) != to) ++d;
  return d;
}

PointKey key_of(const MeshNode& node) {
  const VertexIndex v = vertex_of(node[0]);
  if (node[0] == node[1]) return {v.k, v.j, v.grid, v.i};
  const auto [owner, family] = edge_from(v, direction_between(v, node[1]));
  return {owner.k, owner.j, static_cast<std::int64_t>(corner_kinds + family), owner.i};
}

/// Looks at the boundary around points that may not be simple.
SurfaceFaults faults_at(const std::vector<MeshNode>& doubtful, const WarpedLattice& warped,
                        const Lattice& lattice, const Frame& frame) {
  std::map<PointKey, MeshNode> vertices;
  std::map<std::array<PointKey, 2>, std::array<MeshNode, 2>> edges;
  for (const MeshNode& node : doubtful) {
    const BoundaryAround around = boundary_around(warped.planes, node);
    if (!around.one_fan) vertices.emplace(key_of(node), node);
    for (const MeshNode& other : around.overfull) {
      std::array<MeshNode, 2> ends{node, other};
      std::array<PointKey, 2> keys{key_of(node), key_of(other)};
      if (keys[1] < keys[0]) std::swap(ends[0], ends[1]), std::swap(keys[0], keys[1]);
      edges.emplace(keys, ends);
      vertices.emplace(key_of(other), other);
    }
  }
  const auto place = [&](const MeshNode& node) {
    const VertexIndex v = vertex_of(node[0]);
    return frame.world(node[0] == node[1]
                           ? moved_place(warped, lattice, v)
                           : cut_place(warped, lattice,
                                       edge_from(v, direction_between(v, node[1]))));
  };
  SurfaceFaults faults{edges.size(), vertices.size(), {}, {}};
  for (const auto& [key, node] : vertices)
    if (faults.vertex_places.size() < most_places) faults.vertex_places.push_back(place(node));
  for (const auto& [keys, ends] : edges)
    if (faults.edge_places.size() < most_places)
      faults.edge_places.push_back(middle(place(ends[0]), place(ends[1])));
  return faults;
}

/// Pieces by faces and by vertices of each material.
std::vector<RegionPieces> pieces_of_regions(JoinedRegions& joined,
                                            std::span<const std::int32_t> labels) {
  std::vector<PieceCount> counts(labels.size());
  for (std::uint32_t n = 0; n < joined.materials.size(); ++n) {
    PieceCount& count = counts[static_cast<std::size_t>(joined.materials[n]) - 1];
    count.by_faces += joined.region_by_faces.find(n) == n ? 1 : 0;
    count.by_vertices += joined.region_by_vertices.find(n) == n ? 1 : 0;
  }
  std::vector<RegionPieces> pieces;
  for (std::size_t m = 0; m < labels.size(); ++m)
    if (counts[m].by_faces != 0) pieces.push_back({labels[m], counts[m]});
  return pieces;
}

}  // namespace

JoinedRegions join_regions(const RegionRuns& runs, const WarpedLattice& warped,
                           const Lattice& lattice, const Frame& frame, Context& context) {
  const std::size_t count = runs.size();
  JoinedRegions joined{DisjointSets(count), DisjointSets(0), DisjointSets(count), DisjointSets(0),
                       {}, {}, {}};
  joined.materials.reserve(count);
  for (std::uint32_t n = 0; n < count; ++n) joined.materials.push_back(runs[n].material);
  const std::int32_t layers = lattice.cells[2];
  RegionJoiner joiner(runs, warped, joined);
  for (std::int32_t k = 0; k < layers; ++k) {
    stop_if_cancelled(context);
    joiner.join_rows(k);
  }
  joined.by_faces = joined.region_by_faces;
  joiner.join_across();
  PointJoiner points(joiner, joined);
  const auto nothing = [](const auto&...) {};
  const auto for_each_zero = [&](const auto& visit) {
    for (std::int32_t k = 0; k < layers; ++k) joiner.visit_layer(k, visit, nothing);
  };
  joined.region_by_vertices = joined.region_by_faces;
  for_each_zero([&](const VertexIndex& v) { points.find_shared(v); });
  for_each_zero([&](const VertexIndex& v) { points.join_faces(v); });
  // What faces join, points do.
  for (std::uint32_t n = 0; n < joined.materials.size(); ++n) {
    joined.by_vertices.join(n, joined.by_faces.find(n));
    joined.region_by_vertices.join(n, joined.region_by_faces.find(n));
  }
  std::vector<MeshNode> doubtful;
  for (std::int32_t k = 0; k < layers; ++k)
    joiner.visit_layer(
        k,
        [&](const VertexIndex& v) {
          points.join_points(v);
          if (!points.is_simple(v)) doubtful.push_back({number_of(v), number_of(v)});
        },
        [&](const VertexIndex& v, std::size_t direction) {
          points.join_around_cut(v, direction);
          if (!points.is_touched(v, direction)) return;
          const auto [low, high] = std::minmax({number_of(v), number_of(v.next(direction))});
          doubtful.push_back({low, high});
        });
  joined.surface = faults_at(doubtful, warped, lattice, frame);
  return joined;
}

std::vector<std::uint64_t> count_tets_of_regions(const RegionRuns& runs,
                                                 const JoinedRegions& joined,
                                                 const SignPlanes& planes,
                                                 const std::vector<std::uint32_t>& piece_of,
                                                 std::size_t pieces) {
  std::vector<std::uint64_t> tets(pieces, 0);
  std::map<SharedKey, std::uint32_t> shared_at;
  for (std::size_t n = 0; n < joined.shared.size(); ++n) {
    SharedKey key;
    std::ranges::transform(joined.shared[n], key.begin(), number_of);
    shared_at.emplace(key, piece_of[runs.size() + n]);
  }
  for (std::int32_t k = 0; k < planes.cells()[2]; ++k)
    for (std::int32_t j = 0; j < planes.cells()[1]; ++j) {
      const SignRows signs(planes, j, k);
      for (int w = 0; w < planes.words(); ++w) {
        const CellKinds cells = kinds_of_cells(planes, signs, j, k, w);
        const auto vertex_at = [&](int b, std::size_t v) {
          const auto& [grid, s] = cell.vertices[v];
          return VertexIndex{grid, 64 * w + b + s.x, j + s.y, k + s.z};
        };
        for_each_bit(cells.whole, [&](int b) {
          tets[piece_of[runs.run_of(vertex_at(b, 0))]] += cell_tet_count;
        });
        for_each_bit(cells.any & ~cells.whole, [&](int b) {
          for_each_owned_tet(planes, 64 * w + b, j, k,
                             [&](std::size_t c, const MaterialTet& tet, Material) {
                               if (tet.owner != shared_owner) {
                                 ++tets[piece_of[runs.run_of(
                                     vertex_at(b, cell.corner[c][tet.owner]))]];
                                 return;
                               }
                               SharedKey key;
                               for (std::size_t n = 0; n < 4; ++n)
                                 key[n] = number_of(vertex_at(b, cell.corner[c][n]));
                               std::ranges::sort(key);
                               ++tets[shared_at.at(key)];
                             });
        });
      }
    }
  return tets;
}

Pieces count_region_pieces(const WarpedLattice& warped, const Lattice& lattice,
                           std::span<const std::int32_t> labels, std::uint64_t tets,
                           const Frame& frame, Context& context) {
  const RegionRuns runs(warped.planes, context);
  JoinedRegions joined = join_regions(runs, warped, lattice, frame, context);
  Pieces pieces;
  const NumberedSets by_faces = number_sets(joined.by_faces);
  pieces.whole = {by_faces.count, number_sets(joined.by_vertices).count};
  pieces.regions = pieces_of_regions(joined, labels);
  pieces.largest = tets;
  if (by_faces.count > 1)
    pieces.largest = std::ranges::max(
        count_tets_of_regions(runs, joined, warped.planes, by_faces.of, by_faces.count));
  pieces.surface = std::move(joined.surface);
  return pieces;
}

}  // namespace certet::core
