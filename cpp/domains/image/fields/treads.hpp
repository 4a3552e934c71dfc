#pragma once
/// \file
/// Surfaces that run almost along the planes of voxels: stairs with long treads, and what
/// their voxels share for them to be ramps.
///
/// No window of a few voxels sees that a tread is part of a slope.  But where a tread ends
/// by a step up on one side, and by one down on the other, a straight line between the two
/// ends tells how high the surface is in each of its columns.  Where that is lower than the
/// tread, the label above gets a part of the voxel below; where it is higher, the label below
/// one of the voxel above.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "fields/material_image.hpp"

namespace certet::fields {

/// A voxel of which another label gets a part.
struct Share {
  std::uint16_t voxel;  ///< its number in its cube
  std::uint16_t part;   ///< in 16384ths, less than one half
  Material to;
};

class Treads {
 public:
  static constexpr std::int64_t cube_width = 16;

  /// None.
  Treads() = default;
  /// Of all labels of an image.  \throws Error `cancelled`.
  Treads(const MaterialImage& image, const Context& context);

  /// Calls visit(voxel, part, to) for each share in a cube of voxels.
  template <class Visit>
  void for_each_within(const VoxelCube& cube, const Visit& visit) const {
    if (cubes_.empty()) return;
    std::array<std::int64_t, 3> low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max<std::int64_t>(cube.low[a], 0) / cube_width;
      high[a] = std::min((cube.low[a] + cube.width - 1) / cube_width, counts_[a] - 1);
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
          for (const Share& share : cubes_[number(x, y, z)]) {
            const std::array<std::int64_t, 3> voxel{
                cube_width * x + share.voxel % cube_width,
                cube_width * y + share.voxel / cube_width % cube_width,
                cube_width * z + share.voxel / (cube_width * cube_width)};
            bool within = true;
            for (std::size_t a = 0; a < 3; ++a)
              within = within && voxel[a] >= cube.low[a] && voxel[a] < cube.low[a] + cube.width;
            if (within) visit(voxel, share.part, share.to);
          }
  }

 private:
  [[nodiscard]] std::size_t number(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * counts_[1] + y) * counts_[0] + x);
  }

  std::array<std::int64_t, 3> counts_{};  ///< of cubes
  std::vector<std::vector<Share>> cubes_;
};

}  // namespace certet::fields
