#pragma once
/// \file
/// Where the difference of two fields is 0 along an edge, or a part of one, in a cell.

#include <array>
#include <cstdint>
#include <optional>

#include "certet/lattice/coord3.hpp"
#include "fields/field_point.hpp"

namespace certet::fields {

/// The part of an edge that lies in a cell.  Steps are those of the whole edge; a step's point
/// is rounded down to a 2^20th of a voxel along each axis.
class EdgeInCell {
 public:
  /// From and to points of the edge, which need not lie in the cell; `difference` is that of the
  /// fields at its corners, and stays where it is.
  EdgeInCell(const FieldPoint& first, const FieldPoint& last, const Cell& cell,
             const Corners& difference)
      : difference_(difference) {
    for (std::size_t a = 0; a < 3; ++a) {
      first_[a] = first.at[a] - cell[a] * point_one;
      along_[a] = last.at[a] - first.at[a];
    }
  }

  /// The difference at a step.
  [[nodiscard]] std::int64_t at(std::int32_t step) const {
    std::array<std::int64_t, 3> within;
    for (std::size_t a = 0; a < 3; ++a) within[a] = first_[a] + ((along_[a] * step) >> step_bits);
    return trilinear(difference_, within);
  }

  /// The last step before `high` at which the difference is above 0: `low` if it is not there,
  /// one of these if there are several between steps at which it is not.
  [[nodiscard]] std::int32_t root(std::int32_t low, std::int32_t high) const;

  /// The same where the difference is above 0 at `low` and not at `high`, and falls so steeply
  /// that there is but one such step; none where that is not certain.
  [[nodiscard]] std::optional<std::int32_t> only_root(std::int32_t low, std::int32_t high) const;

 private:
  [[nodiscard]] std::int32_t root_by_lines(std::int32_t low, std::int32_t high) const;

  const Corners& difference_;
  std::array<std::int64_t, 3> first_{}, along_{};
};

}  // namespace certet::fields
