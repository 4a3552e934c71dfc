#pragma once
/// \file
/// Files that announce more than they hold.

#include <filesystem>

namespace certet {

/// Judges the counts that a binary STL, a PLY or an OFF file begins with by the
/// length of the file: memory would be taken for what is announced.
/// \throws Error `bad_input`, the sentence names the file.
void judge_announced_counts(const std::filesystem::path& file);

}  // namespace certet
