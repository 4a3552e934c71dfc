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

}  // namespace certet::formats
