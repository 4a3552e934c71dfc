#include "material_links.hpp"

#include <algorithm>
#include <span>

#include "certet/lattice/material_stencil.hpp"
#include "certet/lattice/well_shaped.hpp"
#include "material_sets.hpp"
#include "places.hpp"

namespace certet::core {
namespace {

/// As the class asks; `zero` are the neighbours that are of no material.
bool are_strict_disks(std::span<const MaterialSets::Entry> around, LinkSet zero) {
  const Material lowest = std::ranges::min(around, {}, &MaterialSets::Entry::material).material;
  LinkSet others = 0;
  for (const auto& [material, set] : around) {
    if (material == lowest) continue;
    if (!is_strict_disk(set, zero)) return false;
    others |= set;
  }
  return around.size() == 2 || is_strict_disk(others, zero);
}

/// Whether two fills of one material would touch each other in an edge alone: on both
/// sides of a cut long edge of the link, with nothing else of the material between.
bool fills_would_touch(const std::array<Material, direction_count>& around) {
  return std::ranges::any_of(long_link_edges, [&](const LinkEdge& edge) {
    const Material first = around[edge.ends[0]];
    const Material last = around[edge.ends[1]];
    const Material side = around[edge.sides[0]];
    return first != last && first != moved_corner && last != moved_corner &&
           side != moved_corner && side == around[edge.sides[1]] && side != first && side != last;
  });
}

}  // namespace

bool MaterialLinks::is_greater(const VertexIndex& v, const Displacement& move) const {
  return material(v) > material(v.next(move.direction));
}

Material MaterialLinks::lower(const VertexIndex& v) const {
  const Displacement& move = violations_.target(v.grid, v.i, v.j, v.k);
  return std::min(material(v), material(v.next(move.direction)));
}

bool MaterialLinks::are_disks(const VertexIndex& v, const Displacement& move,
                              LinkSet zero) const {
  MaterialSets sets;
  sets.add(material(v), 0);
  sets.add(material(v.next(move.direction)), 0);
  std::array<Material, direction_count> around;
  for (std::size_t d = 0; d < direction_count; ++d) {
    const bool moved = (zero >> d & 1) != 0;
    around[d] = moved ? moved_corner : material(v.next(d));
    if (!moved) sets.add(around[d], LinkSet{1} << d);
  }
  return are_strict_disks(sets.entries(), zero) && !fills_would_touch(around);
}

bool MaterialLinks::is_lowest(Material shared, const VertexIndex& v) const {
  for (std::size_t d = 0; d < direction_count; ++d)
    if (material(v.next(d)) < shared) return false;
  return lower(v) == shared;
}

bool MaterialLinks::may_share(const VertexIndex& v, const Displacement& move,
                              LinkSet zero) const {
  const Material shared = lower(v);
  for (const auto& triangle : link_triangles) {
    if (!std::ranges::all_of(triangle, [&](int d) { return (zero >> d & 1) != 0; })) continue;
    if (!is_lowest(shared, v)) return false;
    for (const std::size_t d : triangle)
      if (!is_lowest(shared, v.next(d))) return false;
    if (shared == 0) continue;
    std::array<Coord3, 4> corners{moved_place(lattice_, v, move)};
    for (std::size_t n = 0; n < 3; ++n) {
      const VertexIndex w = v.next(triangle[n]);
      corners[n + 1] = moved_place(lattice_, w, violations_.target(w.grid, w.i, w.j, w.k));
    }
    if (!is_well_shaped(corners)) return false;
  }
  return true;
}

}  // namespace certet::core
