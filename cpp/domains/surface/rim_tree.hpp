#pragma once
/// \file
/// The rims of a surface, in pieces that are seen as one from far away.

#include <cstdint>
#include <vector>

#include "area_moments.hpp"
#include "box_tree.hpp"
#include "certet/frame.hpp"

namespace certet {

/// A loop along which a surface ends, as its triangles run; its first point is there
/// again as its last.
using RimLoop = std::vector<Coord3>;

/// A piece of a rim, or several rims.  From far away it is the edge from its first point
/// to its last and the area between.
struct RimNode {
  std::uint32_t first, last;  ///< in the chain; of several rims both are the same
  std::uint32_t next = 0;     ///< the node after this one and all below it
  IntegerBox box{};
  double length = 0;          ///< of its edges
  double chord = 0;           ///< of the edge that stands for them
  AreaMoments area{};         ///< between its edges and the one
  Point3 centre{0, 0, 0};     ///< of the area or, if there is none, of the box
  double radius = 0;          ///< around the centre
};

/// Rims, and their pieces halved again and again.
struct RimTree {
  std::vector<Coord3> chain;   ///< all rims, one after the other
  std::vector<RimNode> nodes;  ///< before those below them

  /// Points in steps.
  explicit RimTree(const std::vector<RimLoop>& loops);

  /// Whether nothing is below a node: its edges are to be looked at.
  [[nodiscard]] bool is_leaf(std::uint32_t node) const { return nodes[node].next == node + 1; }
};

}  // namespace certet
