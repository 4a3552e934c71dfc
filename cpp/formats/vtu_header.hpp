#pragma once
/// \file
/// What the XML part of a .vtu file says.

#include <cstdint>
#include <map>
#include <string>

#include "input_file.hpp"

namespace certet::formats {

/// An appended array, as announced: nothing of it has been looked at yet.
struct VtuArrayEntry {
  std::string type;
  std::uint64_t components = 1;
  std::uint64_t place = 0;  ///< of its size, in the file
};

struct VtuHeader {
  std::uint64_t points = 0, cells = 0;
  /// By the tag they stand in and their name: "Cells/connectivity".
  std::map<std::string, VtuArrayEntry> arrays;
};

/// Reads the XML before the data.  Refuses, with the reason, all files but those
/// with one piece, raw appended data, 64-bit sizes, this machine's order of
/// bytes and no compression.
VtuHeader read_vtu_header(const InputFile& file);

}  // namespace certet::formats
