#pragma once
/// \file
/// What an NRRD file says of itself, checked before ITK believes it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "header_lines.hpp"
#include "stored_voxels.hpp"

namespace certet {

struct NrrdHeader {
  std::vector<HeaderLine> pairs;  ///< `key:=value`, which programs add on their own
  /// Where the voxels lie, but for how many bytes; nothing where the header does not
  /// say it plainly: voxels in several files, as text, or behind lines to be skipped.
  std::optional<StoredPart> part;
  bool detached = false;

  [[nodiscard]] std::optional<std::string> value(const std::string& key) const;
};

/// Whether a file begins as NRRD does.
bool is_nrrd(const std::filesystem::path& file);

/// Checks the sizes, of which ITK's reader keeps the lowest 64 bits: each must be a
/// whole number from 1 to 2^31; the encoding, for some are not built into ITK; and
/// that the files are there which the header names.
/// \throws Error `bad_input`, the sentence names the file.
NrrdHeader read_nrrd_header(const std::filesystem::path& file);

}  // namespace certet
