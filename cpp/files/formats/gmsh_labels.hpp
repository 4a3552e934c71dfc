#pragma once
/// \file
/// Labels as numbers of Gmsh's physical groups, which begin at 1.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "certet/survey.hpp"

namespace certet::formats {

/// A section that says which groups are of labels that are not positive; empty where none is.
/// Programs that do not know the section pass over it.
std::string gmsh_label_section(const std::vector<Region>& regions);

/// Adds what a line of that section says, of any other line nothing.
void read_gmsh_label(std::string_view line, std::map<std::int32_t, std::int32_t>& label_of_group);

/// As `told_of_labels`.
std::vector<std::string> gmsh_label_losses(const Survey& survey);

}  // namespace certet::formats
