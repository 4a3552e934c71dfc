#pragma once
/// \file
/// Whether voxels of DICOM that are packed in runs are whole.

#include <cstdint>
#include <span>

namespace certet {

/// `packed` is a frame: sixteen numbers, that of the planes and where each begins,
/// then the planes, each with one byte of every voxel, as PackBits writes them.
/// Whether there are `planes` of them, and `voxels` bytes in each.
bool whole_runs(std::span<const unsigned char> packed, std::uint64_t planes, std::uint64_t voxels);

}  // namespace certet
