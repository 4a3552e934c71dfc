#pragma once
/// \file
/// The link of a vertex: its 14 neighbours, a sphere of 36 edges and 24 triangles.

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/direction.hpp"
#include "certet/lattice/orientation.hpp"

namespace certet::core {

/// Some of the neighbours: a bit for each direction.
using LinkSet = std::uint32_t;
/// Of one of them.
constexpr LinkSet only(std::integral auto one) { return LinkSet{1} << one; }
inline constexpr LinkSet whole_link = (LinkSet{1} << direction_count) - 1;

/// The neighbours that are next to neighbour d: the ring around the edge to it, of
/// four around a long and six around a short one.  Two adjacent neighbours have two
/// such neighbours in common, one on each side of their edge.
inline constexpr std::array<std::uint16_t, direction_count> link_ring = [] {
  std::array<std::uint16_t, direction_count> ring{};
  for (std::size_t d = 0; d < direction_count; ++d)
    for (std::size_t e = 0; e < direction_count; ++e)
      for (const Coord3& offset : direction_offset)
        if (direction_offset[d] + offset == direction_offset[e])
          ring[d] = static_cast<std::uint16_t>(ring[d] | 1U << e);
  return ring;
}();

/// The triangles of the link, each in the order in which it is seen from the vertex
/// counter-clockwise from behind: with it, it makes a right-handed tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 3>, 24> link_triangles = [] {
  std::array<std::array<std::uint8_t, 3>, 24> triangles{};
  std::size_t count = 0;
  const auto adjacent = [](std::size_t d, std::size_t e) { return (link_ring[d] >> e & 1) != 0; };
  for (std::uint8_t d = 0; d < direction_count; ++d)
    for (std::uint8_t e = 0; e < direction_count; ++e)
      for (std::uint8_t f = 0; f < direction_count; ++f) {
        if (d > e || d > f || !adjacent(d, e) || !adjacent(e, f) || !adjacent(d, f)) continue;
        if (six_volume({0, 0, 0}, direction_offset[d], direction_offset[e],
                       direction_offset[f]) > 0)
          triangles[count++] = {d, e, f};
      }
  return triangles;
}();

/// The long edges of the link, each with the two neighbours that are next to both of its
/// ends.
struct LinkEdge {
  std::array<std::uint8_t, 2> ends, sides;
};
inline constexpr std::array<LinkEdge, 12> long_link_edges = [] {
  std::array<LinkEdge, 12> edges{};
  std::size_t count = 0;
  for (std::uint8_t d = 0; d < direction_count; ++d)
    for (std::uint8_t e = d + 1; e < direction_count; ++e) {
      if ((link_ring[d] >> e & 1) == 0 || is_long(d) || is_long(e)) continue;
      const auto sides = static_cast<unsigned>(link_ring[d] & link_ring[e]);
      edges[count++] = {{d, e},
                        {static_cast<std::uint8_t>(std::countr_zero(sides)),
                         static_cast<std::uint8_t>(std::bit_width(sides) - 1)}};
    }
  return edges;
}();

/// A bit for each set of neighbours: whether it is not empty, and in one piece.  It is
/// so if it is one neighbour, or next to one of its own the others are, in one piece:
/// whatever is in one piece has a member that holds no two parts of it together.
inline constexpr std::array<std::uint64_t, (whole_link + 1) / 64> connected_sets = [] {
  std::array<std::uint64_t, (whole_link + 1) / 64> connected{};
  std::uint64_t* const words = connected.data();  // compilers count the steps of this
  for (LinkSet set = 1; set <= whole_link; ++set)
    for (LinkSet rest = set; rest != 0; rest &= rest - 1) {
      const LinkSet others = set & ~(rest & -rest);
      if (others != 0 && ((words[others >> 6] >> (others & 63) & 1) == 0 ||
                          (link_ring[static_cast<std::size_t>(std::countr_zero(rest))] & others) == 0))
        continue;
      words[set >> 6] |= std::uint64_t{1} << (set & 63);
      break;
    }
  return connected;
}();

constexpr bool is_connected(LinkSet set) {
  return (connected_sets[set >> 6] >> (set & 63) & 1) != 0;
}

/// Whether the plus neighbours are an open disk whose closure is a closed one with
/// just that interior: they are in one piece, and so are the others; around each
/// zero neighbour those that are plus are one run of its ring and not all of it, or
/// none; and no edge between two zero neighbours has plus on both sides.
/// `StrictDisk` of the certificate.
constexpr bool is_strict_disk(LinkSet plus, LinkSet zero) {
  if (!is_connected(plus) || !is_connected(whole_link & ~plus)) return false;
  for (LinkSet rest = zero; rest != 0; rest &= rest - 1) {
    const LinkSet ring = link_ring[static_cast<std::size_t>(std::countr_zero(rest))];
    const LinkSet run = ring & plus;
    if (run != 0 && (run == ring || !is_connected(run))) return false;
    for (LinkSet other = ring & rest; other != 0; other &= other - 1) {
      const LinkSet sides = ring & link_ring[static_cast<std::size_t>(std::countr_zero(other))];
      if ((sides & ~plus) == 0) return false;
    }
  }
  return true;
}

}  // namespace certet::core
