#include "meta_header.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view separators = "=:", last_key = "ElementDataFile";

bool is_meta(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".mha" || extension == ".mhd";
}

/// As far as a header may reach.
std::string beginning(const fs::path& file) {
  std::string text(std::size_t{1} << 20, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// ITK's reader goes from word to word and not from line to line: where these
/// could differ, it would see other fields than we do.
bool is_field(std::string_view line) {
  const auto is_text = [](char c) {
    return c == '\t' || c == '\r' || (static_cast<unsigned char>(c) >= ' ' && c != 127);
  };
  return std::ranges::all_of(line, is_text) && line.find_first_of(separators) != line.npos;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == line.npos; }

/// The last field names a file, or the header's own if a line ends behind it.
bool is_place(const fs::path& header, const std::string& value, bool ends_a_line) {
  std::error_code failure;
  return !value.empty() &&
         (ends_a_line || fs::is_regular_file(header.parent_path() / value, failure));
}

bool is_number_in(std::string_view text, double least, double greatest) {
  double number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
  return end != text.data() && number >= least && number <= greatest;
}

/// Judges every field of that name, for it is not said here which of them counts.
void judge_number(const fs::path& file, std::string_view key, double least, double greatest,
                  const std::string& reason) {
  const auto header = meta_header(file);
  if (!header) return;
  for (const HeaderLine& field : header->fields)
    if (field.key == key && !is_number_in(field.value, least, greatest)) refuse(file, reason);
}

}  // namespace

std::optional<MetaHeader> meta_header(const fs::path& file) {
  if (!is_meta(file)) return {};
  const std::string text = beginning(file);
  MetaHeader header;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    if (is_blank(line)) continue;
    if (!is_field(line)) refuse(file, "has a header that is not lines of 'key = value'");
    header.fields.push_back(split_line(line, separators));
    const auto& [key, value] = header.fields.back();
    if (key != last_key) continue;
    if (!is_place(file, value, end < text.size())) break;
    header.length = begin;
    return header;
  }
  refuse(file, "does not say where its voxels are");
}

void judge_meta_header(const fs::path& file) {
  judge_number(file, "NDims", 1, 10, "has an impossible number of dimensions");
}

void judge_meta_packed_size(const fs::path& file, std::uint64_t voxel_bytes) {
  judge_number(file, "CompressedDataSize", 0, 2 * static_cast<double>(voxel_bytes) + 4096,
               "has an impossible size of packed data");
}

}  // namespace certet
