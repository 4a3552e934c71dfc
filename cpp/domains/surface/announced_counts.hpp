#pragma once
/// \file
/// Files that announce more than they hold.

#include <filesystem>
#include <string>

namespace certet {

/// The extension in small letters, with the dot.
std::string surface_extension(const std::filesystem::path& file);

/// Checks the count that a binary STL file begins with by the length of the file:
/// memory would be taken for what is announced.
/// \throws Error `bad_input`, the sentence names the file.
void check_announced_counts(const std::filesystem::path& file);

/// Whether an STL file is a text: it begins with the word solid and has no zero byte.
bool is_text_stl(const std::filesystem::path& file);

}  // namespace certet
