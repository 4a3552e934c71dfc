#pragma once
/// \file
/// Files that end too early, or whose packed voxels are damaged.

#include <cstdint>
#include <filesystem>

namespace certet {

/// False where the file is known not to hold all its voxels.  The readers of
/// NIfTI and MetaImage fill what is missing with whatever is in memory, and none
/// of the three looks at checksums, so that packed voxels are unpacked here once
/// more.  `voxel_bytes` are those of all voxels.
bool is_complete(const std::filesystem::path& file, std::uint64_t voxel_bytes);

}  // namespace certet
