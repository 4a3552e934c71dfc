#pragma once
/// \file
/// The pieces of each label of a mesh, layer by layer, before or while it is written.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/mesh.hpp"
#include "certet/pieces.hpp"
#include "certet/stuffing.hpp"
#include "engine/disjoint_sets.hpp"

namespace certet::core {

/// That a point is in a part.
struct PartPoint {
  std::uint64_t point;
  std::uint32_t part;
};

/// Two parts, of the same layer or of two that follow each other.
using PartPair = std::array<std::uint32_t, 2>;

/// The tetrahedra of one layer, in parts that faces join and that have one label each.
struct LayerParts {
  std::vector<std::int32_t> labels;    ///< of the parts
  std::vector<std::uint32_t> of_tets;  ///< the part of each tetrahedron
  std::vector<PartPair> touching;      ///< parts of a label that share points
  /// Which parts are at the points of the layer, and at those of the next one: by points,
  /// of each label one.
  std::vector<PartPoint> at_own, at_next;
};

/// `tets` are those of the layer, `labels` theirs.
template <class Index>
LayerParts find_layer_parts(const Stuffing& stuffing, std::int32_t layer,
                            std::span<const Tet<Index>> tets,
                            std::span<const std::int32_t> labels);

/// What joins the parts of a layer to those of the next.
struct JoinedParts {
  std::vector<PartPair> by_faces, by_points;
};
JoinedParts find_joined_parts(const Stuffing& stuffing, std::int32_t layer,
                              const LayerParts& own, const LayerParts& next);

/// The layers so far, added one after the other.
class RegionParts {
 public:
  /// `joined` to the layer before.
  void add(const LayerParts& layer, const JoinedParts& joined);
  [[nodiscard]] std::vector<RegionPieces> pieces();

 private:
  std::uint32_t first_of_last_ = 0;  ///< the number of the first part of the last layer
  std::vector<std::int32_t> labels_;
  DisjointSets by_faces_{0}, by_points_{0};
};

}  // namespace certet::core
