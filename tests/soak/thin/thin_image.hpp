#pragma once
/// \file
/// Random label images with thin parts.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "certet/image.hpp"

namespace thin {

inline constexpr std::array<std::string_view, 6> image_kinds{
    "vessels", "bars", "lone voxels", "shells", "pores", "touching voxels"};

/// Voxels 0 and 1, the first axis runs fastest.
struct ThinImage {
  std::size_t kind = 0;
  std::array<std::int64_t, 3> size{};
  certet::Point3 spacing{};
  double lattice_size = 0;  ///< at most the smallest spacing
  std::vector<std::uint8_t> voxels;

  [[nodiscard]] certet::Image image() const;
  /// Pieces by faces.
  [[nodiscard]] std::int64_t pieces() const;
};

/// Number `number` of the run with `seed`; depends on these two alone.
ThinImage make_image(std::uint64_t seed, std::uint64_t number);

}  // namespace thin
