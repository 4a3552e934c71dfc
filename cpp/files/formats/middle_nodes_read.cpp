#include "middle_nodes_read.hpp"

#include <limits>
#include <utility>

namespace certet::formats {
namespace {

constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

std::vector<bool> middles_among(const FileMesh& mesh, const InputFile& file) {
  std::vector<bool> is_middle(mesh.points.size());
  for (const auto& nodes : mesh.middles)
    for (const std::uint64_t node : nodes)
      if (node < is_middle.size()) is_middle[node] = true;
  for (const auto& tet : mesh.tets)
    for (const std::uint64_t point : tet)
      if (point < is_middle.size() && is_middle[point])
        file.fail("a node is a corner of one tetrahedron and in the middle of an edge of another");
  return is_middle;
}

/// The numbers of all points among those of their kind.
std::vector<std::uint64_t> parted(FileMesh& mesh, const std::vector<bool>& is_middle) {
  std::vector<Point3> corners;
  std::vector<std::uint64_t> numbers(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    std::vector<Point3>& kind = is_middle[i] ? mesh.middle_points : corners;
    numbers[i] = kind.size();
    kind.push_back(mesh.points[i]);
  }
  mesh.points = std::move(corners);
  return numbers;
}

}  // namespace

void part_middle_nodes(FileMesh& mesh, const EdgeOrder& order, const InputFile& file) {
  if (mesh.middles.empty()) return;
  if (mesh.middles.size() != mesh.tets.size())
    file.fail("it has tetrahedra of four nodes and of ten");
  const std::vector<bool> is_middle = middles_among(mesh, file);
  const std::vector<std::uint64_t> numbers = parted(mesh, is_middle);
  const auto renumber = [&](std::uint64_t& point, bool middle) {
    point = point < numbers.size() && is_middle[point] == middle ? numbers[point] : none;
  };
  for (auto& tet : mesh.tets)
    for (std::uint64_t& point : tet) renumber(point, false);
  for (auto& nodes : mesh.middles) {
    const std::array<std::uint64_t, 6> as_read = nodes;
    for (std::size_t e = 0; e < 6; ++e) nodes[order[e]] = as_read[e];
    for (std::uint64_t& node : nodes) renumber(node, true);
  }
  for (auto& face : mesh.border)
    for (std::uint64_t& point : face) renumber(point, false);
  for (FileSurface& surface : mesh.surfaces)
    for (auto& face : surface.faces)
      for (std::uint64_t& point : face) renumber(point, false);
}

}  // namespace certet::formats
