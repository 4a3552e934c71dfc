#pragma once
/// \file
/// The language of man pages.

#include <string>
#include <string_view>

namespace certet::command {

/// Text as roff shows it unchanged: hyphens that can be copied, no line that is
/// taken for a request, letters beyond ASCII by their numbers.
std::string roff(std::string_view text);

/// The same in bold and in italics.
std::string bold(std::string_view text);
std::string italic(std::string_view text);

}  // namespace certet::command
