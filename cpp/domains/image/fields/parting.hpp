#pragma once
/// \file
/// Where the fields of two labels are equal along an edge.

#include <cstdint>

#include "fields/edge_sides.hpp"
#include "fields/field_point.hpp"
#include "fields/node_fields.hpp"

namespace certet::fields {

/// The image's extent in nodes, both ends included.
struct FieldExtent {
  std::array<std::int64_t, 3> low, high;
  [[nodiscard]] bool contains(const FieldPoint& point) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (point.at[a] < low[a] || point.at[a] > high[a]) return false;
    return true;
  }
};

/// Of one edge after the other.
class Parting {
 public:
  Parting(const NodeFields& fields, const FieldExtent& extent, bool force)
      : extent_(extent), sides_(fields, force) {}

  /// The number of steps, of 2^step_bits in all, after which the edge is on the side of
  /// its last end: the field of that one's label is as great as the other's, or the point
  /// lies beyond the image, or, if those at risk are forced to keep their labels, in a voxel
  /// at risk of the last material (in one of any other it is on the side of the first).  If that
  /// is so more than once, one of those steps; 0 if it is so from the start, the last step if
  /// never.
  std::uint16_t operator()(const FieldEdge& edge);

 private:
  const FieldExtent& extent_;
  EdgeSides sides_;
};

}  // namespace certet::fields
