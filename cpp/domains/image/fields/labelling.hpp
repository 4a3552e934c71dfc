#pragma once
/// \file
/// The label of a point between nodes.

#include "fields/field_cell.hpp"
#include "fields/field_point.hpp"
#include "fields/node_fields.hpp"

namespace certet::fields {

/// Where a lattice point lies in the middle of each cell and the others at nodes, which
/// label is taken there.
enum class Centres {
  as_fields_say,
  /// That with the greatest field of those whose voxels, of the eight, hang together by
  /// faces; if there is none, of all.
  unjoined,
};

/// A point has the label with the greatest field of those of the voxels whose centres
/// are the corners of its cell (of its face or edge where it lies on one); of equal ones
/// the lowest.  In a voxel at risk it has the voxel's, if those are forced to keep theirs.
class Labelling {
 public:
  Labelling(const NodeFields& fields, Centres centres, bool force)
      : fields_(fields), centres_(centres), force_(force) {}

  [[nodiscard]] Material operator()(const FieldPoint& point) const {
    const Cell cell = point.cell();
    return in_block(fields_.block(cell), cell, point);
  }

  /// The same, of a block that is known to hold the point's cell.
  [[nodiscard]] Material in_block(const BlockView& block, const Cell& cell,
                                  const FieldPoint& point) const {
    if (block.labels == 0) return block.only;
    const FieldCell corners(block, cell);
    if ((block.parted >> cell_number(cell) & 1) == 0) return corners.material(corners.node(0).own());
    return in_parted_cell(corners, point.within());
  }

  /// The corner that is nearest; of equally near ones the upper.
  static std::size_t nearest_corner(const std::array<std::int64_t, 3>& within) {
    std::size_t corner = 0;
    for (std::size_t a = 0; a < 3; ++a)
      corner |= static_cast<std::size_t>(within[a] >= point_one / 2) << a;
    return corner;
  }

 private:
  [[nodiscard]] Material in_parted_cell(const FieldCell& cell,
                                        const std::array<std::int64_t, 3>& within) const;

  const NodeFields& fields_;
  Centres centres_;
  bool force_;
};

}  // namespace certet::fields
