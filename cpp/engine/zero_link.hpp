#pragma once
/// \file
/// What the mesh is like around a zero vertex, by the signs of its link.

#include <vector>

#include "link.hpp"

namespace certet::core {

/// Two neighbours of a zero vertex.
struct NeighborPair {
  std::uint8_t a, b;
};

/// The mesh around a zero vertex.  Where the link is a strict disk there is nothing to
/// tell: `LinkFindings{}`.
struct LinkFindings {
  /// Plus neighbours whose tetrahedra share a face of three zero vertices.
  std::vector<NeighborPair> across_faces;
  /// Zero neighbours with which the vertex makes an edge of more than two faces of the
  /// surface.
  LinkSet overfull_edges = 0;
  /// Whether the surface there is one closed fan, or none.
  bool one_fan = true;
};

/// Of the neighbours of a zero vertex.
LinkFindings look_around(LinkSet plus, LinkSet zero);

}  // namespace certet::core
