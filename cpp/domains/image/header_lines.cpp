#include "header_lines.hpp"

#include <algorithm>

namespace certet {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

}  // namespace

HeaderLine split_line(std::string_view line, std::string_view separators) {
  const std::size_t at = line.find_first_of(separators);
  if (at == line.npos) return {trimmed(line), ""};
  return {trimmed(line.substr(0, at)), trimmed(line.substr(at + 1))};
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

}  // namespace certet
