#include "meta_header.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

bool is_meta(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".mha" || extension == ".mhd";
}

/// Up to the key that comes last, as far as a header may reach.
std::string header_of(const fs::path& file) {
  std::string text(std::size_t{1} << 20, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  text.resize(std::min(text.find("ElementDataFile"), text.size()));
  return text;
}

}  // namespace

void judge_meta_header(const fs::path& file) {
  if (!is_meta(file)) return;
  const std::string text = header_of(file);
  constexpr std::string_view key = "NDims";
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at)) {
    at = std::min(text.find_first_not_of("=: \t\r\n", at + key.size()), text.size());
    double dimensions = 0;
    std::from_chars(text.data() + at, text.data() + text.size(), dimensions);
    if (!(dimensions >= 1 && dimensions <= 10))
      refuse(file, "has an impossible number of dimensions");
  }
}

}  // namespace certet
