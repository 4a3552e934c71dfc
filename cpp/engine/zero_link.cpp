#include "zero_link.hpp"

#include <algorithm>

#include "disjoint_sets.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

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

  [[nodiscard]] int arcs_at(int zero) const { return arcs_[node(zero, zero)]; }

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

LinkSet ring(int d) { return link_ring[static_cast<std::size_t>(d)]; }
LinkSet bit(int d) { return LinkSet{1} << d; }

/// Within a triangle of the link, which has plus and minus corners.
void add_arc(const std::array<int, 3>& corners, LinkSet plus, LinkSet zero, LinkCurves& curves) {
  std::array<std::uint32_t, 2> ends{};
  std::size_t found = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const int a = corners[n];
    const int b = corners[(n + 1) % 3];
    if ((zero & bit(a)) != 0) ends[found++] = LinkCurves::node(a, a);
    const LinkSet signs = bit(a) | bit(b);
    if ((zero & signs) == 0 && (plus & signs) != 0 && (plus & signs) != signs)
      ends[found++] = LinkCurves::node(a, b);
  }
  curves.add(ends[0], ends[1]);
}

void add_triangles(LinkSet plus, LinkSet zero, LinkCurves& curves) {
  for (int a = 0; a < direction_count; ++a)
    for_each_bit(ring(a) & ~below(a + 1), [&](int b) {
      for_each_bit(ring(a) & ring(b) & ~below(b + 1), [&](int c) {
        const LinkSet corners = bit(a) | bit(b) | bit(c);
        if ((plus & corners) != 0 && (corners & ~(plus | zero)) != 0)
          add_arc({a, b, c}, plus, zero, curves);
      });
    });
}

}  // namespace

LinkFindings look_around(LinkSet plus, LinkSet zero) {
  LinkFindings found;
  if (is_strict_disk(plus, zero)) return found;
  LinkCurves curves;
  add_triangles(plus, zero, curves);
  // Faces of three zero vertices: of the surface if the mesh has one side of them.
  for_each_bit(zero, [&](int a) {
    for_each_bit(zero & ring(a) & ~below(a + 1), [&](int b) {
      const LinkSet sides = ring(a) & ring(b);
      const LinkSet filled = sides & plus;
      if (filled == sides)
        found.across_faces.push_back({static_cast<std::uint8_t>(std::countr_zero(sides)),
                                      static_cast<std::uint8_t>(std::bit_width(sides) - 1)});
      else if (filled != 0)
        curves.add(LinkCurves::node(a, a), LinkCurves::node(b, b));
    });
  });
  for_each_bit(zero, [&](int d) {
    if (curves.arcs_at(d) > 2) found.overfull_edges |= bit(d);
  });
  found.one_fan = curves.are_one();
  return found;
}

}  // namespace certet::core
