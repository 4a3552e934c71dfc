#pragma once
/// \file
/// The points of a patch or interface, for conditions that solvers put on points.

#include <cstdint>
#include <vector>

#include "sheets.hpp"

namespace certet::formats {

/// Each once, by growing numbers.
std::vector<std::uint64_t> points_of(const Sheets& sheets, const Sheet& sheet);

}  // namespace certet::formats
