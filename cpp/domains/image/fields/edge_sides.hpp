#pragma once
/// \file
/// On which side points of an edge between two labels are.

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "fields/cell_corners.hpp"
#include "fields/field_cell.hpp"
#include "fields/field_point.hpp"
#include "fields/labelling.hpp"
#include "fields/node_fields.hpp"

namespace certet::fields {

/// An edge from a point of one material to a point of another.
struct FieldEdge {
  FieldPoint first, last;
  Material of_first, of_last;
};

/// Of one edge after the other.  The block and the cell of the last point are kept, for the next
/// one mostly lies there too.
class EdgeSides {
 public:
  EdgeSides(const NodeFields& fields, bool force) : fields_(fields), force_(force) {}

  void start(const FieldEdge& edge) {
    if (edge.of_first != of_first_ || edge.of_last != of_last_) {
      of_first_ = edge.of_first;
      of_last_ = edge.of_last;
      find_labels();
    }
    at_ = nowhere;
  }

  bool is_first(const FieldPoint& point) {
    const auto forced = forced_at(point);
    return forced ? *forced : trilinear(difference_, point.within()) > 0;
  }

  /// Where a label is forced, whether that is the first side.
  std::optional<bool> forced_at(const FieldPoint& point) {
    enter(point.cell());
    if (!some_forced_) return std::nullopt;
    const Material forced = forced_[Labelling::nearest_corner(point.within())];
    if (forced == not_forced) return std::nullopt;
    return forced != of_last_;
  }

  /// Of the two fields, at the corners of a point's cell.
  const Corners& difference_at(const FieldPoint& point) {
    enter(point.cell());
    return difference_;
  }

  /// Whether two points lie in one cell, where some labels are forced nearest to one corner.
  bool are_together(const FieldPoint& one, const FieldPoint& other) {
    const Cell cell = one.cell();
    if (cell != other.cell()) return false;
    enter(cell);
    return !some_forced_ || Labelling::nearest_corner(one.within()) ==
                                Labelling::nearest_corner(other.within());
  }

  /// Of the two fields, at the corners of a cell; nullptr where one of these is forced.
  const Corners* difference_in(const Cell& cell) {
    enter(cell);
    return some_forced_ ? nullptr : &difference_;
  }

 private:
  static constexpr Material not_forced = -1;
  static constexpr Cell nowhere{-1, -1, -1};

  static Cell block_of(const Cell& cell) {
    return {cell[0] / block_cells, cell[1] / block_cells, cell[2] / block_cells};
  }

  void enter(const Cell& cell) {
    if (cell != at_) enter_new(cell);
  }

  void enter_new(const Cell& cell) {
    at_ = cell;
    some_forced_ = false;
    if (const Cell block = block_of(cell); block != block_at_) {
      block_at_ = block;
      block_ = fields_.block(cell);
      find_labels();
    }
    if (block_.labels == 0) {
      difference_.fill(block_.only == of_last_ ? -1 : 1);
      return;
    }
    const std::size_t node = first_node_number(cell);
    Eight first{}, last{};
    if (of_first_values_ != nullptr) spread(corner_pairs(of_first_values_ + node), first);
    if (of_last_values_ != nullptr) spread(corner_pairs(of_last_values_ + node), last);
    first -= last;
    std::memcpy(&difference_, &first, sizeof(difference_));
    if (force_ && (block_.at_risk >> cell_number(cell) & 1) != 0) find_forced(cell);
  }

  /// A label that is not near has none in the block.
  void find_labels() {
    of_first_values_ = of_last_values_ = nullptr;
    for (std::size_t l = 0; l < block_.labels; ++l) {
      if (block_.materials[l] == of_first_) of_first_values_ = block_.values + l * nodes_of_block;
      if (block_.materials[l] == of_last_) of_last_values_ = block_.values + l * nodes_of_block;
    }
  }

  void find_forced(const Cell& cell) {
    const FieldCell corners(block_, cell);
    for (std::size_t c = 0; c < 8; ++c) {
      const Node& node = corners.node(c);
      forced_[c] = node.at_risk() ? corners.material(node.own()) : not_forced;
    }
    some_forced_ = true;
  }

  const NodeFields& fields_;
  bool force_;
  Material of_first_ = not_forced, of_last_ = not_forced;
  Cell at_ = nowhere, block_at_ = nowhere;
  BlockView block_;
  const std::int16_t *of_first_values_ = nullptr, *of_last_values_ = nullptr;
  Corners difference_{};  ///< of the first material's field and the last one's
  std::array<Material, 8> forced_{};
  bool some_forced_ = false;
};

}  // namespace certet::fields
