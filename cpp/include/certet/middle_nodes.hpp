#pragma once
/// \file
/// Tetrahedra of ten nodes: a node in the middle of each edge.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "certet/mesh.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// The edges of a tetrahedron, by its corners, in the order in which VTK, Abaqus and FEBio have
/// their middle nodes.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> tet_edges{
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// How far a middle node lies from the middle of its edge.
struct Bend {
  std::uint64_t node = 0;  ///< counted from 0 among the middle nodes
  Coord3 by{};             ///< in half steps
  friend bool operator==(const Bend&, const Bend&) = default;
};

/// The middle nodes of a mesh: one for each edge, which all tetrahedra around it share.  They
/// are numbered by the lower and then by the higher end of their edges, and come behind the
/// corners in files.  Takes some six bytes for each tetrahedron.
class MiddleNodes {
 public:
  MiddleNodes() = default;
  /// `first[a]` is the first edge of which point a is the lower end, and `reach` how much
  /// higher the other end of each is, ascending for each point.
  MiddleNodes(std::vector<std::uint64_t> first, std::vector<std::uint32_t> reach)
      : first_(std::move(first)), reach_(std::move(reach)) {}

  /// The points of the mesh, which are the corners of its tetrahedra.
  [[nodiscard]] std::uint64_t corners() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] std::uint64_t count() const { return reach_.size(); }

  /// The middle node between two points, from 0; `count()` if no edge joins them.
  [[nodiscard]] std::uint64_t between(std::uint64_t a, std::uint64_t b) const;
  /// Those of a tetrahedron of the mesh, in the order of `tet_edges`.
  template <class Index>
  [[nodiscard]] std::array<std::uint64_t, 6> of(const Tet<Index>& tet) const {
    std::array<std::uint64_t, 6> nodes;
    for (std::size_t e = 0; e < 6; ++e)
      nodes[e] = between(tet[tet_edges[e][0]], tet[tet_edges[e][1]]);
    return nodes;
  }

  /// Calls visit(node, a, b) for the edges of which a is the lower end, from `begin` to `end`.
  template <class Visit>
  void for_each(std::uint64_t begin, std::uint64_t end, const Visit& visit) const {
    for (std::uint64_t a = begin; a < end; ++a)
      for (std::uint64_t node = first_[a]; node < first_[a + 1]; ++node)
        visit(node, a, a + reach_[node]);
  }
  /// The first edge of which `point` or a higher one is the lower end.
  [[nodiscard]] std::uint64_t first(std::uint64_t point) const { return first_[point]; }

  /// Of those that are not in the middle of their edges, by growing numbers.
  [[nodiscard]] std::span<const Bend> bends() const { return bends_; }
  /// By growing numbers; none is zero.
  void set_bends(std::vector<Bend> bends) { bends_ = std::move(bends); }

  [[nodiscard]] std::uint64_t bytes() const;

 private:
  std::vector<std::uint64_t> first_;
  std::vector<std::uint32_t> reach_;
  std::vector<Bend> bends_;
};

/// That of a node, 0 where it has none.  `bends` are by growing numbers.
Coord3 bend_of(std::span<const Bend> bends, std::uint64_t node);

/// The middle nodes of a mesh, in the middle of their edges.
/// \throws Error `too_large` (out of memory, or an edge between points whose numbers differ by
/// 2^32), `cancelled`, `bad_option` (a tetrahedron names a point that is not there).
MiddleNodes middle_nodes(const Mesh& mesh, Context& context);
MiddleNodes middle_nodes(const Mesh& mesh);
/// The same of a mesh that is counted but not written.
MiddleNodes middle_nodes(const Stuffing& stuffing, Context& context);
/// The same of tetrahedra alone, among so many points.
MiddleNodes middle_nodes(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets);

/// Where a middle node is in the world: between `a` and `b`, bent by half steps.
Point3 middle_in_world(const Frame& frame, Coord3 a, Coord3 b, Coord3 bend);

/// All of them, in the order of their numbers.  \throws Error `too_large` (out of memory).
std::vector<Point3> middle_points(const Mesh& mesh, const MiddleNodes& middles);

}  // namespace certet
