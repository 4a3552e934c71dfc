#pragma once
/// \file
/// What a MetaImage says of itself, judged before ITK believes it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "header_lines.hpp"

namespace certet {

/// The fields of a MetaImage's header, the last of which says where the voxels are.
struct MetaHeader {
  std::vector<HeaderLine> fields;
  std::uint64_t length;  ///< bytes; the voxels begin behind it if they are in the same file
};

/// Nothing for files of other formats.
/// \throws Error `bad_input` if it is not lines of text, each `key = value`, or ends
///   before it says where the voxels are.
std::optional<MetaHeader> meta_header(const std::filesystem::path& file);

/// Judges the number of dimensions, which ITK's reader takes as it comes and
/// counts up to: from 1 to 10, as many as MetaIO has room for.  Files of other
/// formats are let pass.
/// \throws Error `bad_input`, the sentence names the file.
void judge_meta_header(const std::filesystem::path& file);

/// Judges how many bytes the packed voxels are said to have, for which ITK's reader
/// makes room at once: no more than twice the bytes of the voxels, and 4096.
/// \throws Error `bad_input`, the sentence names the file.
void judge_meta_packed_size(const std::filesystem::path& file, std::uint64_t voxel_bytes);

}  // namespace certet
