#pragma once
/// \file
/// Where a voxel is, in words.

#include <cstdint>
#include <string>

#include "certet/image.hpp"

namespace certet {

/// (i, j, k) of voxel number `at`, from 0.
inline std::string voxel_place(const Image& image, std::uint64_t at) {
  const auto nx = static_cast<std::uint64_t>(image.size[0]);
  const auto ny = static_cast<std::uint64_t>(image.size[1]);
  return "voxel (" + std::to_string(at % nx) + ", " + std::to_string(at / nx % ny) + ", " +
         std::to_string(at / nx / ny) + ")";
}

}  // namespace certet
