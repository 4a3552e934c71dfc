#pragma once
/// \file
/// What an NRRD file says of itself, judged before ITK believes it.

#include <filesystem>

namespace certet {

/// Judges the sizes, of which ITK's reader keeps the lowest 64 bits: each must be a
/// whole number from 1 to 2^31.  Files of other formats are let pass.
/// \throws Error `bad_input`, the sentence names the file.
void judge_nrrd_header(const std::filesystem::path& file);

}  // namespace certet
