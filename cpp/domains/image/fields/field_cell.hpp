#pragma once
/// \file
/// A cell of a block where several labels are near.

#include <array>
#include <cstddef>
#include <cstdint>

#include "fields/cell_corners.hpp"
#include "fields/field_point.hpp"
#include "fields/field_tile.hpp"

namespace certet::fields {

class FieldCell {
 public:
  FieldCell(const BlockView& block, const Cell& cell)
      : block_(block), first_(first_node_number(cell)) {}

  [[nodiscard]] const Node& node(std::size_t corner) const {
    return block_.nodes[first_ + cell_corners[corner]];
  }
  /// By its number in the block.
  [[nodiscard]] Material material(std::size_t label) const { return block_.materials[label]; }

  /// What the field of a label is at the corners.
  [[nodiscard]] Corners values(std::size_t label) const {
    Eight spread_out;
    spread(corner_pairs(block_.values + label * nodes_of_block + first_), spread_out);
    Corners corners;
    std::memcpy(&corners, &spread_out, sizeof(corners));
    return corners;
  }

 private:
  const BlockView& block_;
  std::size_t first_;
};

}  // namespace certet::fields
