#include "sheet_points.hpp"

#include <algorithm>

namespace certet::formats {

std::vector<std::uint64_t> points_of(const Sheets& sheets, const Sheet& sheet) {
  std::vector<std::uint64_t> points;
  points.reserve(3 * sheet.faces);
  sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
    points.insert(points.end(), face.points.begin(), face.points.end());
  });
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<std::uint64_t> nodes_of(const Sheets& sheets, const Sheet& sheet,
                                    ElementNodes& nodes) {
  if (!nodes.has_middles()) return points_of(sheets, sheet);
  std::vector<std::uint64_t> all;
  sheets.for_each_face(sheet, [&](const BoundaryFace& face) {
    const std::span<const std::uint64_t> own = nodes.face(face.points);
    all.insert(all.end(), own.begin(), own.end());
  });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace certet::formats
