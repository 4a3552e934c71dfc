#pragma once
/// \file
/// What the mesh is like around a zero vertex, by its link.

#include <array>
#include <cstdint>
#include <vector>

#include "link.hpp"

namespace certet::core {

/// The link of a zero vertex.  A neighbour that is neither plus nor zero is minus.
struct ZeroLink {
  LinkSet plus = 0, zero = 0;
  /// Where several materials meet, the triangles of zero neighbours that make a tetrahedron
  /// of the mesh with the vertex, as numbers of `link_triangles`.
  std::uint32_t filled = 0;
  /// And the long edges between two materials that have no plus beside, as numbers of
  /// `long_link_edges`.  The space between three materials is of the one across from the
  /// long edge: if that is the outside on both sides, it pinches the mesh at the edge's cut.
  std::uint32_t bare = 0;

  [[nodiscard]] LinkSet minus() const { return whole_link & ~(plus | zero); }
};

/// What tetrahedra at a vertex have in common besides it: a plus neighbour, or the triangle
/// `member - direction_count` of the link.
using LinkMember = std::uint8_t;

/// The mesh around a zero vertex.
struct LinkFindings {
  /// Those on the two sides of faces of three zero vertices.
  std::vector<std::array<LinkMember, 2>> across_faces;
  /// Zero neighbours, and long edges of the link, with which, or with the cuts of which, the
  /// vertex makes an edge of more than two faces of the surface.
  LinkSet overfull_edges = 0;
  std::uint32_t overfull_cuts = 0;
  /// Whether the surface there is one closed fan, or none.
  bool one_fan = true;
};

/// Whether there is nothing to find: the surface is one closed fan, or there is none, and
/// edges of the link join all that is plus.
bool is_simple(const ZeroLink& link);

LinkFindings look_around(const ZeroLink& link);

}  // namespace certet::core
