#pragma once
/// \file
/// From positions on a lattice to points among the nodes of fields.

#include <array>
#include <cmath>
#include <cstdint>

#include "certet/lattice/coord3.hpp"
#include "fields/field_point.hpp"
#include "fields/parting.hpp"
#include "placement.hpp"

namespace certet::fields {

class FieldFrame {
 public:
  explicit FieldFrame(const std::array<VoxelAxis, 3>& axes) : axes_(axes) {
    constexpr std::int64_t half = point_one / 2;
    for (std::size_t a = 0; a < 3; ++a) {
      // As `VoxelAxis::covers` has it, one end is inside and the other is not.
      const std::int64_t open = axes[a].reversed ? 1 : 0;
      extent_.low[a] = half + open;
      extent_.high[a] = axes[a].count * point_one + half - 1 + open;
    }
  }

  /// Voxels between the outermost faces of the image.
  [[nodiscard]] const FieldExtent& extent() const { return extent_; }

  /// `position` is in steps; rounded to a 2^20th of a voxel.
  [[nodiscard]] FieldPoint at(Coord3 position) const {
    constexpr double unit = 1.0 / steps;
    return {{along(0, unit * position.x), along(1, unit * position.y),
             along(2, unit * position.z)}};
  }

  /// The same of a lattice point, in lattice units.
  [[nodiscard]] FieldPoint at_lattice(Coord3 point) const {
    return {{along(0, point.x), along(1, point.y), along(2, point.z)}};
  }

  /// `lattice` is in lattice units.
  [[nodiscard]] std::int64_t along(std::size_t axis, double lattice) const {
    const double voxel = axes_[axis].forward(lattice);
    const auto forward = static_cast<std::int64_t>(
        std::floor(voxel * static_cast<double>(point_one) + 0.5));
    return axes_[axis].reversed ? axes_[axis].count * point_one - forward : forward + point_one;
  }

  [[nodiscard]] bool covers(std::size_t axis, std::int64_t at) const {
    return at >= extent_.low[axis] && at <= extent_.high[axis];
  }

 private:
  std::array<VoxelAxis, 3> axes_;
  FieldExtent extent_{};
};

}  // namespace certet::fields
