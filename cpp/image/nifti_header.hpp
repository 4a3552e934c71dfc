#pragma once
/// \file
/// What a NIfTI file says of itself, judged before ITK believes it.

#include <filesystem>

namespace certet {

/// Judges the numbers that place the voxels in the world: spacing, quaternion,
/// offset and matrix.  ITK's reader ends the whole program where an axis made of
/// them is not finite.  Files of other formats are let pass.
/// \throws Error `bad_input`, the sentence names the file.
void judge_nifti_header(const std::filesystem::path& file);

}  // namespace certet
