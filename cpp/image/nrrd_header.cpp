#include "nrrd_header.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

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

constexpr std::string_view key = "sizes:";

/// Names of fields are read in capitals too.
bool is_sizes(const std::string& line) {
  return line.size() > key.size() && std::equal(key.begin(), key.end(), line.begin(),
    [](char k, char c) { return k == std::tolower(static_cast<unsigned char>(c)); });
}

}  // namespace

void judge_nrrd_header(const fs::path& file) {
  constexpr std::size_t longest = 1 << 16;  // of a line that may still be a header's
  std::ifstream stream(file, std::ios::binary);
  std::string line(4, '\0');
  stream.read(line.data(), 4);
  if (line != "NRRD") return;
  while (std::getline(stream, line) && line.size() < longest) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) return;  // the voxels begin
    if (!is_sizes(line)) continue;
    std::istringstream words(line.substr(key.size()));
    for (std::string word; words >> word;)
      if (!is_size(word)) refuse(file, "has impossible dimensions");
  }
}

}  // namespace certet
