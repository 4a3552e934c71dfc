#pragma once
/// \file
/// Headers that name the files of their voxels by a pattern.

#include <filesystem>
#include <string>
#include <vector>

namespace certet {

/// More than this many files of one image are not looked for.
inline constexpr long most_files = 100000;

/// The files that `name%03d.raw first last step` names, beside the header, as NRRD
/// and MetaImage have it; a step, and for NRRD a number of dimensions, may follow.
/// Where the text is no such pattern, the one file that it is the name of.
/// \throws Error `bad_input` naming the header, for numbers that make no sense.
std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& header,
                                                  const std::string& text);

}  // namespace certet
