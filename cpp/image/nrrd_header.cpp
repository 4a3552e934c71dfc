#include "nrrd_header.hpp"

#include <charconv>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include "header_lines.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// Whether a word is a number of voxels that an image may have along an axis.
bool is_size(const std::string& word) {
  std::uint64_t size = 0;
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, size);
  return failure == std::errc() && stop == end && size >= 1 && size <= std::uint64_t{1} << 31;
}

}  // namespace

void judge_nrrd_header(const fs::path& file) {
  constexpr std::size_t longest = 1 << 16;  // of a line that may still be a header's
  std::ifstream stream(file, std::ios::binary);
  std::string line(4, '\0');
  stream.read(line.data(), 4);
  if (line != "NRRD") return;
  while (std::getline(stream, line) && line.size() < longest) {
    if (line.empty() || line == "\r") return;  // the voxels begin
    const auto [key, value] = split_line(line, ":");
    if (lower(key) != "sizes") continue;
    std::istringstream words(value);
    for (std::string word; words >> word;)
      if (!is_size(word)) refuse(file, "has impossible dimensions");
  }
}

}  // namespace certet
