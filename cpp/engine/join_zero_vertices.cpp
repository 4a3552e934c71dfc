#include <algorithm>
#include <array>
#include <vector>

#include "layer_joins.hpp"
#include "material_sets.hpp"
#include "zero_link.hpp"

namespace certet::core {
namespace {

bool has_all(LinkSet set, LinkSet some) { return (set & some) == some; }

/// The signs around the zero vertices of a word, read 64 at once, as most have others near.
class WordLinks {
 public:
  WordLinks(const SignPlanes& planes, const VertexIndex& first) {
    const SignRows rows(planes, first.j, first.k);
    for (std::size_t d = 0; d < direction_count; ++d)
      around_[d] = rows.at(neighbor(first.grid, d), first.i >> 6);
  }

  [[nodiscard]] ZeroLink link(int b) const {
    ZeroLink link;
    for (std::size_t d = 0; d < direction_count; ++d) {
      link.plus |= static_cast<LinkSet>(around_[d].plus >> b & 1) << d;
      link.zero |= static_cast<LinkSet>(around_[d].zero >> b & 1) << d;
    }
    return link;
  }

 private:
  std::array<SignWord, direction_count> around_;
};

/// One zero vertex, with the parts around it.
class ZeroVertex {
 public:
  ZeroVertex(const PlusRuns& runs, const ZeroTets& zero_tets, const VertexIndex& v,
             const ZeroLink& link)
      : runs_(runs), zero_tets_(zero_tets), v_(v), link_(link) {
    if (!runs.have_materials()) return;
    find_materials();
    find_filled();
    find_bare();
  }

  /// Whether edges join all that is around it, each material too, and the surface is one fan.
  [[nodiscard]] bool is_simple() const {
    return core::is_simple(link_) && std::ranges::all_of(sets_.entries(), [](const auto& entry) {
             return is_connected(entry.set);
           });
  }

  void add(LayerJoins& found) const {
    const LinkFindings around = look_around(link_);
    for (const auto& [a, b] : around.across_faces)
      found.by_faces.push_back({part(a), part(b)});
    join_all(found);
    if (!around.one_fan) found.vertices.push_back(PointIndex::corner(v_));
    const auto add_edge = [&](const PointIndex& to) { found.add_edge(PointIndex::corner(v_), to); };
    for_each_bit(around.overfull_edges, [&](int d) { add_edge(PointIndex::corner(next(d))); });
    for_each_bit(around.overfull_cuts, [&](int e) {
      const auto [a, b] = long_link_edges[static_cast<std::size_t>(e)].ends;
      add_edge(PointIndex::cut(next(a), direction_between(a, b)));
    });
  }

 private:
  [[nodiscard]] VertexIndex next(int d) const { return v_.next(static_cast<std::size_t>(d)); }

  /// The direction from one neighbour to another that is next to it.
  static std::size_t direction_between(std::size_t a, std::size_t b) {
    std::size_t d = 0;
    while (!(direction_offset[a] + direction_offset[d] == direction_offset[b])) ++d;
    return d;
  }

  void find_materials() {
    for_each_bit(link_.plus, [&](int d) {
      const VertexIndex u = next(d);
      sets_.add(runs_.planes().materials()->at(u.grid, u.i, u.j, u.k), only(d));
    });
  }

  void find_filled() {
    if (zero_tets_.size() == 0 || std::popcount(link_.zero) < 3) return;
    for (std::size_t t = 0; t < link_triangles.size(); ++t) {
      const auto [a, b, c] = link_triangles[t];
      if (has_all(link_.zero, only(a) | only(b) | only(c)) && zero_tets_.find(case_at(v_, t)))
        link_.filled |= std::uint32_t{1} << t;
    }
  }

  void find_bare() {
    for (std::size_t e = 0; e < long_link_edges.size(); ++e) {
      const auto& [ends, sides] = long_link_edges[e];
      const LinkSet both = only(ends[0]) | only(ends[1]);
      const LinkSet beside = only(sides[0]) | only(sides[1]);
      if (!has_all(link_.plus, both) || (link_.plus & beside) != 0) continue;
      const bool alike = std::ranges::any_of(
          sets_.entries(), [both](const auto& entry) { return has_all(entry.set, both); });
      if (!alike) link_.bare |= std::uint32_t{1} << e;
    }
  }

  [[nodiscard]] std::uint32_t part(LinkMember member) const {
    if (member < direction_count) return runs_.run_of(v_.next(member));
    return runs_.size() + *zero_tets_.find(case_at(v_, member - std::size_t{direction_count}));
  }

  [[nodiscard]] Material material(LinkMember member) const {
    for (const auto& [material, set] : sets_.entries())
      if (member < direction_count && has_all(set, only(member))) return material;
    return runs_.have_materials() ? runs_.planes().materials()->at(v_.grid, v_.i, v_.j, v_.k) : 0;
  }

  /// All that is around it, of each material first.
  void join_all(LayerJoins& found) const {
    std::vector<LinkMember> members;
    for_each_bit(link_.plus, [&](int d) { members.push_back(static_cast<LinkMember>(d)); });
    for_each_bit(link_.filled,
                 [&](int t) { members.push_back(static_cast<LinkMember>(direction_count + t)); });
    std::ranges::stable_sort(members, {}, [&](LinkMember m) { return material(m); });
    for (std::size_t n = 1; n < members.size(); ++n)
      found.by_vertices.push_back({part(members[n - 1]), part(members[n])});
  }

  const PlusRuns& runs_;
  const ZeroTets& zero_tets_;
  const VertexIndex& v_;
  ZeroLink link_;
  MaterialSets sets_;  ///< of the plus neighbours, where there are several
};

}  // namespace

void add_zero_vertices(const PlusRuns& runs, const ZeroTets& zero_tets, std::int32_t k,
                       LayerJoins& found) {
  const SignPlanes& planes = runs.planes();
  for (std::int32_t j = 0; j < planes.cells()[1]; ++j)
    for (const Grid grid : grids)
      for (int w = 0; w < planes.words(); ++w) {
        const std::uint64_t zero = planes.zero(grid, j, k)[w];
        if (zero == 0) continue;
        const VertexIndex first{grid, 64 * w, j, k};
        const WordLinks links(planes, first);
        for_each_bit(zero, [&](int b) {
          const VertexIndex v{grid, 64 * w + b, j, k};
          const ZeroVertex vertex(runs, zero_tets, v, links.link(b));
          if (!vertex.is_simple()) vertex.add(found);
        });
      }
}

}  // namespace certet::core
