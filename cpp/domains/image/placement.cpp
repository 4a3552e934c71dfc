#include "placement.hpp"

#include <algorithm>
#include <string>

#include "certet/error.hpp"
#include "certet/lattice/structured_tet.hpp"

namespace certet {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

double long_edge(const Image& image, const ImageLattice& choice) {
  const double finest = *std::min_element(image.spacing.begin(), image.spacing.end());
  checked_margin(choice.margin);
  return checked_size(choice.size == 0 ? finest : choice.size);
}

/// Places one axis; returns the cells.  Origin and shift centre the lattice's
/// coordinates around 0, so that their whole range can be used.
std::int32_t place_axis(VoxelAxis& axis, double spacing, double size, std::int32_t margin,
                        double lead, std::int64_t low, std::int64_t high, std::int32_t& origin) {
  if (axis.reversed) {
    std::swap(low, high);
    low = axis.count - 1 - low;
    high = axis.count - 1 - high;
  }
  axis.scale = size / (2 * spacing);
  // No lattice point ties between voxels then, where the size is a whole multiple or a
  // whole fraction of the spacing.
  const double even = -lead * std::min(1.0, size / spacing);
  const auto cell_of = [&](double forward) {
    return std::floor((forward - even) / (2 * axis.scale));
  };
  const double first = cell_of(static_cast<double>(low) - 0.5) - margin;
  const double last = cell_of(static_cast<double>(high) + 0.5) + margin;
  const std::int32_t cells = checked_cells(last - first + 1);
  origin = -2 * (cells / 2);
  axis.shift = even + (2 * first - origin) * axis.scale;
  return cells;
}

/// The world position of a voxel's centre, or of what lies between centres.
Point3 voxel_position(const Image& image, const Point3& voxel) {
  Point3 world = image.origin;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a)
      world[r] += image.axes[r][a] * image.spacing[a] * voxel[a];
  return world;
}

/// From one of the outermost corners of an image's voxels to the other.  A point of the lattice that
/// lies in the upper face is beyond the image (`VoxelAxis::covers`), and so it is beyond the box: that
/// ends earlier there, by more than rounding moves a point and by less than a step.
BorderBox border_of(const Image& image, const std::array<VoxelAxis, 3>& axes, const Frame& frame) {
  constexpr double shorter = 1e-8;  // lattice units
  Point3 first, last;
  for (std::size_t a = 0; a < 3; ++a) {
    const double by = shorter * (frame.size / 2) / image.spacing[a];
    first[a] = -0.5 + (axes[a].reversed ? by : 0);
    last[a] = static_cast<double>(image.size[a]) - 0.5 - (axes[a].reversed ? 0 : by);
  }
  return BorderBox::along_frame(frame, voxel_position(image, first), voxel_position(image, last));
}

}  // namespace

Placement place(const Image& image, const VoxelBox& box, const ImageLattice& choice, double lead) {
  const double size = long_edge(image, choice);
  Placement result;
  result.frame = {image.origin, image.axes, size};
  // The engine's tetrahedra are positive in lattice coordinates; a rotation
  // keeps them so, a reflection would not.  The last axis is turned round,
  // since rows along the first one read memory forward.
  const bool reflected = determinant(image.axes) < 0;
  std::int32_t* origin[3] = {&result.lattice.origin.x, &result.lattice.origin.y,
                             &result.lattice.origin.z};
  for (std::size_t a = 0; a < 3; ++a) {
    VoxelAxis& axis = result.axis[a];
    axis.count = image.size[a];
    result.longest_side =
        std::max(result.longest_side,
                 image.spacing[a] * static_cast<double>(box.high[a] - box.low[a] + 1));
    axis.reversed = reflected && a == 2;
    result.lattice.cells[a] =
        place_axis(axis, image.spacing[a], size, choice.margin, lead, box.low[a], box.high[a],
                   *origin[a]);
    const double stored_shift =
        axis.reversed ? static_cast<double>(axis.count - 1) - axis.shift : axis.shift;
    for (std::size_t r = 0; r < 3; ++r) {
      result.frame.origin[r] += image.axes[r][a] * (image.spacing[a] * stored_shift);
      if (axis.reversed) result.frame.axes[r][a] = -image.axes[r][a];
    }
  }
  result.border.push_back(border_of(image, result.axis, result.frame));
  return result;
}

VoxelInterval voxels_between(const VoxelAxis& axis, double low, double high,
                             bool interpolated) {
  const double from = axis.forward(low), to = axis.forward(high);
  const double end = static_cast<double>(axis.count) - 0.5;
  VoxelInterval result;
  if (to < -0.5 || from >= end) return result;
  result.whole = from >= -0.5 && to < end;
  const double reach = interpolated ? 0.0 : 0.5;
  const auto clamped = [&](double voxel) {
    return static_cast<std::int64_t>(
        std::clamp(voxel, 0.0, static_cast<double>(axis.count - 1)));
  };
  result.low = clamped(std::floor(from + reach));
  result.high = clamped(std::floor(to + reach) + (interpolated ? 1 : 0));
  if (axis.reversed) {
    std::swap(result.low, result.high);
    result.low = axis.stored(result.low);
    result.high = axis.stored(result.high);
  }
  return result;
}

std::optional<VoxelReach> voxels_within(const Placement& placement, const LatticeBox& box,
                                        bool interpolated) {
  const std::array<double, 3> low{double(box.low.x), double(box.low.y), double(box.low.z)};
  const std::array<double, 3> high{double(box.high.x), double(box.high.y), double(box.high.z)};
  VoxelReach reach;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto voxels = voxels_between(placement.axis[a], low[a], high[a], interpolated);
    if (voxels.low > voxels.high) return std::nullopt;
    reach.voxels.low[a] = voxels.low;
    reach.voxels.high[a] = voxels.high;
    reach.whole = reach.whole && voxels.whole;
  }
  return reach;
}

}  // namespace certet
