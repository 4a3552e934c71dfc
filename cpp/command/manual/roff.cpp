#include "roff.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace certet::command {
namespace {

/// Reads one character of UTF-8 and moves past it.
std::uint32_t next_character(std::string_view text, std::size_t& at) {
  const auto first = static_cast<std::uint8_t>(text[at++]);
  const int length = std::countl_one(first);
  if (length == 0) return first;
  std::uint32_t character = first & (0x7fu >> length);
  for (int n = 1; n < length && at < text.size(); ++n)
    character = character << 6 | (static_cast<std::uint8_t>(text[at++]) & 0x3fu);
  return character;
}

}  // namespace

std::string roff(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out = "\\&";
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t character = next_character(text, at);
    if (character == '-') out += "\\-";
    else if (character == '\\') out += "\\e";
    else if (character == '^') out += "\\(ha";
    else if (character == '~') out += "\\(ti";
    else if (character == '`') out += "\\(ga";
    else if (character < 128) out += static_cast<char>(character);
    else out += fmt::format("\\[u{:04X}]", character);
  }
  return out;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", roff(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", roff(text)); }

}  // namespace certet::command
