#pragma once
/// \file
/// A mesh to look at.

#include "certet/formats.hpp"
#include "certet/function_domain.hpp"
#include "certet/stuffing.hpp"

namespace certet::view {

/// A ball around the origin of so many long edges across, with two labels.
inline FileMesh ball(double edges) {
  Frame frame{.size = 1};
  const double radius = edges / 2;
  FunctionDomain domain([radius](Point3 p) {
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - radius * radius;
  }, frame);
  Context context;
  const int reach = 2 * static_cast<int>(radius) + 6;
  const Mesh mesh =
      stuff(domain, {{-reach, -reach, -reach}, {reach, reach, reach}}, frame, {}, context);
  FileMesh file;
  for (const Coord3& point : mesh.points) file.points.push_back(frame.world(point));
  std::visit([&file](const auto& tets) {
    for (const auto& t : tets) {
      file.tets.push_back({t[0], t[1], t[2], t[3]});
      file.labels.push_back(file.points[t[0]][2] > 0 ? 7 : 3);
    }
  }, mesh.tets);
  return file;
}

}  // namespace certet::view
