#pragma once
/// \file
/// Files that end too early.

#include <cstdint>
#include <filesystem>

namespace certet {

/// False where a NIfTI or MetaImage file is known to end before its last voxel.
/// Their readers fill what is missing with whatever is in memory, and say
/// nothing; the NRRD reader does notice.  `voxel_bytes` are those of all voxels.
bool is_complete(const std::filesystem::path& file, std::uint64_t voxel_bytes);

}  // namespace certet
