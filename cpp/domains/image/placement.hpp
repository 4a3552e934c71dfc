#pragma once
/// \file
/// How lattice and voxel grid lie upon each other.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "certet/domain.hpp"
#include "certet/image.hpp"

namespace certet {

/// One axis of the image.  The lattice may run against the voxels: `forward`
/// counts voxels the lattice's way, `stored` as they are in memory.
struct VoxelAxis {
  std::int64_t count = 0;
  bool reversed = false;
  double scale = 1;  ///< voxels per lattice unit
  double shift = 0;  ///< forward voxel coordinate of lattice coordinate 0

  /// The forward voxel coordinate of a lattice coordinate; whole numbers are
  /// voxel centres.
  [[nodiscard]] double forward(double lattice) const { return shift + scale * lattice; }

  [[nodiscard]] bool covers(double forward) const {
    return forward >= -0.5 && forward < static_cast<double>(count) - 0.5;
  }
  [[nodiscard]] std::int64_t stored(std::int64_t forward) const {
    return reversed ? count - 1 - forward : forward;
  }
  /// The stored number of the nearest voxel, or -1 beyond the outermost ones.
  [[nodiscard]] std::int64_t nearest(double lattice) const {
    const double at = forward(lattice);
    return covers(at) ? stored(static_cast<std::int64_t>(std::floor(at + 0.5))) : -1;
  }
};

/// Stored voxels low to high, both ends included; empty where low > high.
struct VoxelBox {
  std::array<std::int64_t, 3> low, high;
};

/// Lattice, frame and axes of an image.
struct Placement {
  Lattice lattice;
  Frame frame;
  std::array<VoxelAxis, 3> axis;
  std::vector<BorderBox> border;  ///< the box of all voxels of the image
  double longest_side = 0;  ///< of the box of voxels, in world units
};

/// Puts a lattice around the voxels of `box`, with an even point `lead` of a voxel (or of a
/// cell, if that is less) before the centre of voxel 0; less than 1/2.  From 1/4 on no
/// lattice point ties between voxels; at 0 odd ones do.
/// \throws Error `bad_option` (size, margin), `too_large` (coordinate range).
Placement place(const Image& image, const VoxelBox& box, const ImageLattice& choice, double lead);

/// The stored voxel numbers, low to high, of the part of an interval of lattice
/// coordinates that lies in the image.
struct VoxelInterval {
  std::int64_t low = 0, high = -1;  ///< empty where low > high
  bool whole = false;               ///< no part of the interval is beyond the image
};

/// With the voxels that trilinear interpolation reaches for, if `interpolated`.
VoxelInterval voxels_between(const VoxelAxis& axis, double low, double high,
                             bool interpolated);

/// The stored voxels of the part of a lattice box that lies in the image.
struct VoxelReach {
  VoxelBox voxels;
  bool whole = true;  ///< no part of the box is beyond the image
};

/// Nothing if all of the box is beyond the image.
std::optional<VoxelReach> voxels_within(const Placement& placement, const LatticeBox& box,
                                        bool interpolated);

}  // namespace certet
