#include "zero_link.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "row_ranks.hpp"

namespace certet::core {
namespace {

LinkSet ring(int d) { return link_ring[static_cast<std::size_t>(d)]; }

template <std::size_t count>
LinkSet set_of(const std::array<std::uint8_t, count>& neighbours) {
  LinkSet set = 0;
  for (const std::uint8_t d : neighbours) set |= only(d);
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
  using Node = std::uint8_t;
  /// A neighbour that is zero, or the cut between two neighbours.
  static Node node(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<Node>(low * direction_count + high);
  }

  void add(Node from, Node to) { arcs_.push_back({from, to}); }

  [[nodiscard]] std::ptrdiff_t arcs_at(Node node) const {
    return std::ranges::count_if(arcs_, [node](const Arc& arc) { return has_end(arc, node); });
  }

  /// Whether all arcs make one closed curve, or there are none.
  [[nodiscard]] bool are_one() const {
    std::vector<Arc> rest = arcs_;
    if (rest.empty()) return true;
    const Node start = rest.back()[0];
    Node at = start;
    // Whoever comes back to the start with no arc left has gone along all of them; a node
    // passed twice would have four.
    do {
      if (arcs_at(at) != 2) return false;
      const auto next =
          std::ranges::find_if(rest, [at](const Arc& arc) { return has_end(arc, at); });
      at = (*next)[0] == at ? (*next)[1] : (*next)[0];
      rest.erase(next);
    } while (at != start);
    return rest.empty();
  }

 private:
  using Arc = std::array<Node, 2>;
  static bool has_end(const Arc& arc, Node node) { return arc[0] == node || arc[1] == node; }

  std::vector<Arc> arcs_;
};

/// The surface in the triangles of a link.
class LinkSurface {
 public:
  explicit LinkSurface(const ZeroLink& link) : link_(link) {
    if (link.minus() != 0) add_arcs();
    add_faces();
  }

  LinkFindings findings() {
    found_.one_fan = curves_.are_one();
    if (!found_.one_fan)
      for_each_bit(link_.zero, [&](int d) {
        if (curves_.arcs_at(LinkCurves::node(d, d)) > 2) found_.overfull_edges |= only(d);
      });
    return std::move(found_);
  }

 private:
  void add_arcs() {
    found_.overfull_cuts = pinched_edges(link_);
    for (const auto& triangle : link_triangles) {
      const LinkSet corners = set_of(triangle);
      if ((link_.plus & corners) != 0 && (link_.minus() & corners) != 0) add_arc(triangle);
    }
  }

  void add_faces() {
    for_each_bit(link_.zero, [&](int a) {
      for_each_bit(link_.zero & ring(a) & ~below(a + 1), [&](int b) { add_face(a, b); });
    });
  }

  /// Within a triangle that has plus and minus corners.
  void add_arc(const std::array<std::uint8_t, 3>& triangle) {
    std::array<LinkCurves::Node, 2> ends{};
    std::size_t found = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      const int a = triangle[n];
      const int b = triangle[(n + 1) % 3];
      if ((link_.zero & only(a)) != 0) ends[found++] = LinkCurves::node(a, a);
      const LinkSet edge = only(a) | only(b);
      if ((link_.plus & edge) != 0 && (link_.minus() & edge) != 0)
        ends[found++] = LinkCurves::node(a, b);
    }
    for_each_bit(found_.overfull_cuts, [&](int e) {
      const LinkEdge& edge = long_link_edges[static_cast<std::size_t>(e)];
      if (set_of(edge.ends) != (set_of(triangle) & link_.plus)) return;
      const LinkCurves::Node cut = LinkCurves::node(edge.ends[0], edge.ends[1]);
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
      const LinkSet edge = only(a) | only(b);
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
