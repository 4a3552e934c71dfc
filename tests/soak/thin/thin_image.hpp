#pragma once
/// \file
/// Random label images with thin parts.

#include <array>
#include <cstdint>
#include <string_view>

#include "../voxel_image.hpp"

namespace thin {

inline constexpr std::array<std::string_view, 6> image_kinds{
    "vessels", "bars", "lone voxels", "shells", "pores", "touching voxels"};

/// Voxels 0 and 1.
struct ThinImage : soak::VoxelImage {
  std::size_t kind = 0;
  double lattice_size = 0;  ///< at most the smallest spacing

  /// Pieces by faces.
  [[nodiscard]] std::int64_t pieces() const;
};

/// Number `number` of the run with `seed`; depends on these two alone.
ThinImage make_image(std::uint64_t seed, std::uint64_t number);

}  // namespace thin
