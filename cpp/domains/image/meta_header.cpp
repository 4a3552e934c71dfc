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

constexpr std::size_t longest_key = 80, longest_value = 1000;
constexpr std::string_view separators = "=:", last_key = "ElementDataFile";

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

}  // namespace

bool is_meta(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".mha" || extension == ".mhd";
}

MetaHeader read_meta_header(const fs::path& file) {
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
    // MetaIO has arrays of a fixed length for both, and writes beyond them.
    if (key.size() > longest_key || value.size() > longest_value)
      refuse(file, "has a header with a line that is too long for its format");
    if (key != last_key) continue;
    if (!is_place(file, value, end < text.size())) break;
    header.length = begin;
    for (const HeaderLine& field : header.fields)  // it is not said which of them counts
      if (field.key == "NDims" && !is_number_in(field.value, 1, 10))
        refuse(file, "has an impossible number of dimensions");
    return header;
  }
  refuse(file, "does not say where its voxels are");
}

std::string MetaHeader::value(std::string_view key) const {
  const auto found = std::ranges::find(fields.rbegin(), fields.rend(), key, &HeaderLine::key);
  return found == fields.rend() ? "" : found->value;
}

bool MetaHeader::is_true(std::string_view key) const {
  const std::string text = value(key);
  return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

}  // namespace certet
