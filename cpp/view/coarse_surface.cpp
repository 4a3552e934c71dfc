#include "coarse_surface.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "triangles.hpp"

namespace certet::view {
namespace {

CoarseSurface as_it_is(const FileMesh& mesh, std::span<const SeparatingFace> faces) {
  PointSubset subset(mesh.points.size());
  for (const SeparatingFace& face : faces) subset.add(face.points);
  subset.number();
  CoarseSurface surface;
  for (const std::uint64_t point : subset.points()) surface.points.push_back(mesh.points[point]);
  for (const auto& [points, tet, other] : faces)
    surface.triangles.push_back(
        {{subset[points[0]], subset[points[1]], subset[points[2]]}, tet, other});
  return surface;
}

CoarseSurface clustered(const CoarseSurface& fine, const Point3& low, double cell) {
  CoarseSurface surface;
  surface.cell = cell;
  std::unordered_map<std::uint64_t, std::uint32_t> cells;
  std::vector<std::uint32_t> number(fine.points.size());
  std::vector<double> members;
  cells.reserve(fine.points.size() / 4);
  for (std::size_t i = 0; i < fine.points.size(); ++i) {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      key = key << 21 |
            static_cast<std::uint64_t>((fine.points[i][axis] - low[axis]) / cell);
    const auto [at, is_new] =
        cells.try_emplace(key, static_cast<std::uint32_t>(surface.points.size()));
    if (is_new) surface.points.push_back({}), members.push_back(0);
    number[i] = at->second;
    ++members[at->second];
    for (std::size_t axis = 0; axis < 3; ++axis)
      surface.points[at->second][axis] += fine.points[i][axis];
  }
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    for (double& coordinate : surface.points[i]) coordinate /= members[i];
  for (const auto& [points, tet, other] : fine.triangles) {
    const auto [a, b, c] = std::array{number[points[0]], number[points[1]], number[points[2]]};
    if (a != b && b != c && c != a) surface.triangles.push_back({{a, b, c}, tet, other});
  }
  return surface;
}

}  // namespace

CoarseSurface coarse_surface(const FileMesh& mesh, std::span<const SeparatingFace> faces,
                             std::uint64_t limit) {
  CoarseSurface fine = as_it_is(mesh, faces);
  if (faces.size() <= limit) return fine;
  const Box box = box_of(mesh, faces);
  // A surface of n triangles has about sqrt(n) along a side.
  double cell = box.width() / std::sqrt(static_cast<double>(limit));
  for (;;) {
    CoarseSurface coarse = clustered(fine, box.low, cell);
    const double excess =
        static_cast<double>(coarse.triangles.size()) / static_cast<double>(limit);
    if (excess <= 1) return coarse;
    // Cells twice as wide leave about a quarter of the triangles.
    cell *= 1.05 * std::sqrt(excess);
  }
}

}  // namespace certet::view
