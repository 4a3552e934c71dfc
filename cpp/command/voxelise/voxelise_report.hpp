#pragma once
/// \file
/// What `certet voxelise` tells.

#include <cstdint>
#include <string>
#include <vector>

#include "certet/voxelise.hpp"

namespace certet::command {

/// What is known at the end.
struct VoxeliseReport {
  std::string input, output;  ///< no output: labels were only compared
  std::uint64_t bytes = 0;    ///< of the output
  std::uint64_t tets = 0;
  VoxelisedMesh made;
  std::string compared;                ///< the image that it was compared with, if any
  std::vector<LabelOverlap> overlaps;  ///< with that or, without one, with itself: voxels alone
  LabelNames names;
  std::vector<std::string> warnings;
  double seconds = 0;
};

std::string table(const VoxeliseReport& report);
std::string json(const VoxeliseReport& report);

}  // namespace certet::command
