#pragma once
/// \file
/// Lines of headers that are text, as NRRD and MetaImage have them.

#include <string>
#include <string_view>

namespace certet {

/// Without blanks around either; a line without a separator is a key alone.
struct HeaderLine {
  std::string key, value;
};

/// Splits at the first of the separators.
HeaderLine split_line(std::string_view line, std::string_view separators);

/// In small letters, where they are of ASCII.
std::string lower(std::string text);

}  // namespace certet
