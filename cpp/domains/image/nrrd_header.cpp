#include "nrrd_header.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string_view>

#include "image_file.hpp"
#include "numbered_files.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest = 1 << 16;  // of a line that may still be a header's

/// Whether a word is a number of voxels that an image may have along an axis.
bool is_size(const std::string& word) {
  std::uint64_t size = 0;
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, size);
  return failure == std::errc() && stop == end && size >= 1 && size <= std::uint64_t{1} << 31;
}

void check_sizes(const fs::path& file, const std::string& value) {
  std::istringstream words(value);
  for (std::string word; words >> word;)
    if (!is_size(word)) refuse(file, "has impossible dimensions");
}

void check_encoding(const fs::path& file, const std::string& encoding) {
  constexpr std::string_view known = " raw txt text ascii hex gz gzip ";
  if (encoding == "bz2" || encoding == "bzip2")
    refuse(file, "is packed by bzip2, which is not supported; pack it by gzip");
  if (encoding.empty() || known.find(" " + encoding + " ") == known.npos)
    refuse(file, "has voxels in an encoding that is not known, '" + encoding + "'");
}

/// One name, a pattern with numbers, or a list that ends the file.
std::vector<fs::path> data_files(const fs::path& file, const std::string& value,
                                 std::istream& stream) {
  if (value.rfind("LIST", 0) != 0) {
    std::error_code failure;
    if (fs::exists(file.parent_path() / value, failure)) return {file.parent_path() / value};
    return numbered_files(file, value);
  }
  std::vector<fs::path> files;
  for (std::string line; std::getline(stream, line) && line.size() < longest;)
    if (std::string name = split_line(line, "\n").key; !name.empty())
      files.push_back(file.parent_path() / name);
  return files;
}

struct Reading {
  std::string encoding;
  std::vector<fs::path> files;
  bool skips = false;
};

void read_field(const fs::path& file, const HeaderLine& line, std::istream& stream,
                NrrdHeader& header, Reading& reading) {
  const std::string key = lower(line.key);
  if (key == "sizes") check_sizes(file, line.value);
  if (key == "encoding") check_encoding(file, reading.encoding = lower(line.value));
  if ((key == "line skip" || key == "lineskip" || key == "byte skip" || key == "byteskip") &&
      line.value != "0")
    reading.skips = true;
  if (key != "data file" && key != "datafile") return;
  header.detached = true;
  reading.files = data_files(file, line.value, stream);
}

void check_files(const fs::path& file, const Reading& reading) {
  std::error_code failure;
  for (const fs::path& data : reading.files)
    if (!fs::is_regular_file(data, failure))
      refuse(file, "is a header whose voxels are missing: there is no file '" + data.string() + "'");
}

}  // namespace

std::optional<std::string> NrrdHeader::value(const std::string& key) const {
  const auto found = std::ranges::find(pairs, key, &HeaderLine::key);
  return found == pairs.end() ? std::nullopt : std::optional(found->value);
}

bool is_nrrd(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string word(4, '\0');
  stream.read(word.data(), 4);
  return stream && word == "NRRD";
}

NrrdHeader read_nrrd_header(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  NrrdHeader header;
  Reading reading;
  std::string line;
  bool ended = false;
  std::getline(stream, line);
  while (!ended && std::getline(stream, line) && line.size() < longest) {
    ended = line.empty() || line == "\r";  // the voxels begin
    if (ended || line[0] == '#') continue;
    const std::size_t pair = line.find(":=");
    if (pair != line.npos && line.find(": ") >= pair)
      header.pairs.push_back({split_line(line.substr(0, pair), "\n").key,
                              split_line(line.substr(pair + 2), "\n").key});
    else
      read_field(file, split_line(line, ":"), stream, header, reading);
  }
  check_files(file, reading);
  const bool packed = reading.encoding == "gzip" || reading.encoding == "gz";
  if (reading.skips || reading.files.size() > 1 || (!packed && reading.encoding != "raw"))
    return header;
  if (header.detached && reading.files.size() == 1)
    header.part = StoredPart{reading.files[0], 0, 0, 0, packed};
  else if (ended)
    header.part = StoredPart{file, static_cast<std::uint64_t>(stream.tellg()), 0, 0, packed};
  return header;
}

}  // namespace certet
