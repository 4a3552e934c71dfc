#pragma once
/// \file
/// Sizes that vary from place to place, by --size-field.

#include <cstdint>
#include <string>

#include "certet/size_field.hpp"

namespace certet::command {

/// Whether the text is one of an image or a formula.  \throws Error `bad_option` where it is
/// something else.
void check_size_field(const std::string& text);

/// A formula, that of a file as @FILE, or the image in a file: what has the name of an image and
/// what is there.  \throws Error `bad_input`, `too_large`.
SizeField open_sizes(const std::string& text, std::uint64_t max_bytes);

}  // namespace certet::command
