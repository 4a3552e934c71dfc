#pragma once
/// \file
/// What the XML part of a .vtu file says.

#include <cstdint>
#include <map>
#include <string>

#include "input_file.hpp"

namespace certet::formats {

/// How the numbers of an array are written.
enum class VtuEncoding { raw, base64, ascii };

/// An array, as announced: nothing of it has been looked at yet.
struct VtuArrayEntry {
  std::string type;
  std::uint64_t components = 1;
  VtuEncoding encoding = VtuEncoding::raw;
  std::uint64_t place = 0;  ///< of what is written, in the file
};

struct VtuHeader {
  std::uint64_t points = 0, cells = 0;
  bool wide_sizes = false;  ///< UInt64, not UInt32
  bool compressed = false;  ///< by vtkZLibDataCompressor
  bool appended = false;    ///< whether there are data behind the XML
  std::string space;        ///< as `MeshSize` has it
  /// By the tag they stand in and their name: "Cells/connectivity".
  std::map<std::string, VtuArrayEntry> arrays;
};

/// Reads the XML.  Refuses, with the reason, all files but those with one piece,
/// this machine's order of bytes, and no compression but zlib's.
VtuHeader read_vtu_header(const InputFile& file);

}  // namespace certet::formats
