#pragma once
/// \file
/// Distances between a mesh and its shape, for people and for programs.

#include <string>
#include <vector>

#include "certet/distance.hpp"
#include "certet/page.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// What was measured, and what the shape's surface is.
struct DistanceReport {
  DistanceFigures figures;
  std::string against;  ///< "the triangles of the surface"
};

/// Each way: "greatest 0.1211 edges (0.02422) at (0, 1, 2), rms 0.03112 (0.006224)".
std::string sentence(const Distance& distance, double edge);

void add_distance(Lines& lines, const DistanceReport& report);
Json json_of(const DistanceReport& report);
/// What `json_of` made.  \throws nlohmann's exceptions where it is something else.
DistanceReport distance_of(const Json& json);
std::vector<PageRow> page_rows(const DistanceReport& report);

}  // namespace certet::command
