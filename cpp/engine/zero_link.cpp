#include "zero_link.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "disjoint_sets.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

LinkSet ring(int d) { return link_ring[static_cast<std::size_t>(d)]; }
LinkSet bit(int d) { return LinkSet{1} << d; }

template <std::size_t count>
LinkSet set_of(const std::array<std::uint8_t, count>& neighbours) {
  LinkSet set = 0;
  for (const std::uint8_t d : neighbours) set |= LinkSet{1} << d;
  return set;
}

/// Those of the bare edges whose sides are both minus.
std::uint32_t pinched_edges(const ZeroLink& link) {
  std::uint32_t pinched = link.bare;
  for_each_bit(link.bare, [&](int e) {
    if ((link.zero & set_of(long_link_edges[static_cast<std::size_t>(e)].sides)) != 0)
      pinched &= ~(std::uint32_t{1} << e);
  });
  return pinched;
}

bool has_triangle(LinkSet set) {
  return std::ranges::any_of(link_triangles, [set](const auto& triangle) {
    const LinkSet corners = set_of(triangle);
    return (set & corners) == corners;
  });
}

/// Where the surface cuts the link: arcs between zero neighbours and cuts of its edges.
class LinkCurves {
 public:
  /// A neighbour that is zero, or the cut between two neighbours.
  static std::uint32_t node(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint32_t>(low * direction_count + high);
  }

  void add(std::uint32_t from, std::uint32_t to) {
    for (const std::uint32_t end : {from, to}) ++arcs_[end];
    curves_.join(from, to);
  }

  [[nodiscard]] int arcs_at(std::uint32_t node) const { return arcs_[node]; }

  /// Whether all arcs make one closed curve, or there are none.
  [[nodiscard]] bool are_one() {
    std::uint32_t first = node_count;
    for (std::uint32_t n = 0; n < node_count; ++n) {
      if (arcs_[n] == 0) continue;
      if (first == node_count) first = n;
      if (arcs_[n] != 2 || curves_.find(n) != curves_.find(first)) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t node_count = direction_count * direction_count;
  DisjointSets curves_{node_count};
  std::array<int, node_count> arcs_{};
};

/// The surface in the triangles of a link.
class LinkSurface {
 public:
  explicit LinkSurface(const ZeroLink& link) : link_(link) {
    found_.overfull_cuts = pinched_edges(link);
    for (const auto& triangle : link_triangles) {
      const LinkSet corners = set_of(triangle);
      if ((link.plus & corners) != 0 && (link.minus() & corners) != 0) add_arc(triangle);
    }
    for_each_bit(link.zero, [&](int a) {
      for_each_bit(link.zero & ring(a) & ~below(a + 1), [&](int b) { add_face(a, b); });
    });
  }

  LinkFindings findings() {
    for_each_bit(link_.zero, [&](int d) {
      if (curves_.arcs_at(LinkCurves::node(d, d)) > 2) found_.overfull_edges |= bit(d);
    });
    found_.one_fan = curves_.are_one();
    return std::move(found_);
  }

 private:
  /// Within a triangle that has plus and minus corners.
  void add_arc(const std::array<std::uint8_t, 3>& triangle) {
    std::array<std::uint32_t, 2> ends{};
    std::size_t found = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      const int a = triangle[n];
      const int b = triangle[(n + 1) % 3];
      if ((link_.zero & bit(a)) != 0) ends[found++] = LinkCurves::node(a, a);
      const LinkSet edge = bit(a) | bit(b);
      if ((link_.plus & edge) != 0 && (link_.minus() & edge) != 0)
        ends[found++] = LinkCurves::node(a, b);
    }
    for_each_bit(found_.overfull_cuts, [&](int e) {
      const LinkEdge& edge = long_link_edges[static_cast<std::size_t>(e)];
      if (set_of(edge.ends) != (set_of(triangle) & link_.plus)) return;
      const std::uint32_t cut = LinkCurves::node(edge.ends[0], edge.ends[1]);
      curves_.add(std::exchange(ends[0], cut), cut);
    });
    curves_.add(ends[0], ends[1]);
  }

  /// The face of the vertex and two zero neighbours: of the surface if the mesh has one
  /// side of it.
  void add_face(int a, int b) {
    std::array<LinkMember, 2> members{};
    std::size_t count = 0;
    for_each_bit(ring(a) & ring(b) & link_.plus,
                 [&](int d) { members[count++] = static_cast<LinkMember>(d); });
    for_each_bit(link_.filled, [&](int t) {
      const LinkSet edge = bit(a) | bit(b);
      if ((set_of(link_triangles[static_cast<std::size_t>(t)]) & edge) == edge)
        members[count++] = static_cast<LinkMember>(direction_count + t);
    });
    if (count == 2) found_.across_faces.push_back(members);
    if (count == 1) curves_.add(LinkCurves::node(a, a), LinkCurves::node(b, b));
  }

  const ZeroLink& link_;
  LinkCurves curves_;
  LinkFindings found_;
};

}  // namespace

bool is_simple(const ZeroLink& link) {
  if (link.filled != 0 || link.bare != 0) return false;
  if (is_strict_disk(link.plus, link.zero)) return true;
  return link.minus() == 0 && is_connected(link.plus) && !has_triangle(link.zero);
}

LinkFindings look_around(const ZeroLink& link) { return LinkSurface(link).findings(); }

}  // namespace certet::core
