#pragma once
/// \file
/// The points of a patch or interface, for conditions that solvers put on points.

#include <cstdint>
#include <vector>

#include "element_nodes.hpp"
#include "sheets.hpp"

namespace certet::formats {

/// Each once, by growing numbers.
std::vector<std::uint64_t> points_of(const Sheets& sheets, const Sheet& sheet);

/// The same with the middle nodes, if there are any.
std::vector<std::uint64_t> nodes_of(const Sheets& sheets, const Sheet& sheet, ElementNodes& nodes);

}  // namespace certet::formats
