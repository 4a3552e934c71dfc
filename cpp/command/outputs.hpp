#pragma once
/// \file
/// Files that a run writes: checked before the long work.

#include <cstdint>
#include <filesystem>
#include <string>

#include "certet/formats.hpp"

namespace certet::command {

/// \throws Error `write_failed` where a file could not be put there, `bad_option` for
/// `-`, which stands for stdout where a text is written.
void check_output(const std::filesystem::path& file);

/// The same of all files of a mesh; of OpenFOAM's folder one that is there may hold nothing else.
void check_mesh_output(const std::filesystem::path& file, Format format);

/// \throws Error `write_failed` where the disk has less room than this.
void check_room(const std::filesystem::path& file, std::uint64_t bytes);

/// Whether two names mean one file.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Writes a text under a temporary name and renames it; `-` is stdout.
/// \throws Error `write_failed`.
void write_text(const std::string& target, const std::string& text);

}  // namespace certet::command
