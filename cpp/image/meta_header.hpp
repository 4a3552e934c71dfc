#pragma once
/// \file
/// What a MetaImage says of itself, judged before ITK believes it.

#include <filesystem>

namespace certet {

/// Judges the number of dimensions, which ITK's reader takes as it comes and
/// counts up to: from 1 to 10, as many as MetaIO has room for.  Files of other
/// formats are let pass.
/// \throws Error `bad_input`, the sentence names the file.
void judge_meta_header(const std::filesystem::path& file);

}  // namespace certet
