#pragma once
/// \file
/// Edges of a mesh's boundary that are to run along a curve.

#include <vector>

#include "sites.hpp"

namespace certet::features {

/// Vertices one behind the other, joined by edges of the boundary; of a loop the first is the last,
/// too.
struct Chain {
  std::vector<Number> vertices;
  std::vector<Coord3> targets;  ///< where they are to be
  std::vector<std::uint8_t> pinned;  ///< whether that is a bend or an end, from where none moves on

  [[nodiscard]] bool empty() const { return vertices.empty(); }
};

/// What chains are looked for among.
struct ChainSearch {
  const Zone& zone;
  const Sites& sites;
  const std::vector<std::uint8_t>& taken;  ///< vertices of other chains, and corners
  const std::vector<double>& dislike;      ///< of vertices, added to what they cost
};

/// The chain along a curve from one vertex to another, of which the sum of the squared distances is
/// about the least, so that each edge that passes from one patch beside to the other has an end in
/// it.  No three vertices of it are those of a triangle.  `none`, for an end at which no vertex is,
/// means any; of a loop both are.
Chain find_chain(const ChainSearch& search, std::uint32_t curve, Number first, Number last);

}  // namespace certet::features
