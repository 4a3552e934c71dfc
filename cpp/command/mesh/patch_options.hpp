#pragma once
/// \file
/// Patches of the boundary: those that the user names, and how large all are.

#include <string>
#include <vector>

#include "certet/formats.hpp"
#include "certet/patches.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// What --patch says, NAME=WHERE each.
/// \throws Error `bad_option`, also if the format has no patches.
std::vector<PatchChoice> chosen_patches(const std::vector<std::string>& texts, Format format);

/// For people.
void add_patches(Lines& lines, const std::vector<PatchFigures>& patches);
/// For programs.
Json json_of(const std::vector<PatchFigures>& patches);

}  // namespace certet::command
