#pragma once
/// \file
/// Random label images: noise, thin sheets, lone voxels, nested balls, cells.

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string_view>

#include "../voxel_image.hpp"

namespace labelled {

using Random = std::mt19937_64;

inline constexpr std::array<std::string_view, 6> image_kinds{
    "noise", "blocks", "sheets", "lone voxels", "nested balls", "cells"};

/// How many pieces the voxels of a label make.
struct VoxelPieces {
  std::int64_t by_corners = 0, by_faces = 0;
};

/// Labels 1 to 12, and 0.  There are two labels at least.
struct LabelImage : soak::VoxelImage {
  /// Of each label.
  [[nodiscard]] std::map<std::int32_t, VoxelPieces> pieces() const;
};

/// An image of a kind of `image_kinds`, of 3 to 6 voxels along each axis.
LabelImage make_image(std::size_t kind, Random& random);

}  // namespace labelled
