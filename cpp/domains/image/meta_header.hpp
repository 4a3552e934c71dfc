#pragma once
/// \file
/// What a MetaImage says of itself, checked before ITK believes it.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "header_lines.hpp"

namespace certet {

/// The fields of a MetaImage's header, the last of which says where the voxels are.
struct MetaHeader {
  std::vector<HeaderLine> fields;
  std::uint64_t length = 0;  ///< bytes; the voxels begin behind it if they are in the same file

  /// Of the last field of that name; empty where there is none.
  [[nodiscard]] std::string value(std::string_view key) const;
  /// Whether it begins with T or 1, by which MetaIO tells.
  [[nodiscard]] bool is_true(std::string_view key) const;
};

/// By its name, for its lines have no mark.
bool is_meta(const std::filesystem::path& file);

/// Checks the number of dimensions too, which ITK's reader takes as it comes and
/// counts up to: from 1 to 10, as many as MetaIO has room for.
/// \throws Error `bad_input` if it is not lines of text, each `key = value`, or ends
///   before it says where the voxels are.
MetaHeader read_meta_header(const std::filesystem::path& file);

}  // namespace certet
