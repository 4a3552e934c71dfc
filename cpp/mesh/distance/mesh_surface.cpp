#include <algorithm>
#include <limits>
#include <variant>

#include "certet/distance.hpp"
#include "certet/error.hpp"
#include "engine/parallel.hpp"
#include "runs.hpp"

namespace certet {

using distance::in_memory;

namespace {

/// The surface with the numbers that the mesh has for its points, and these, by growing numbers.
struct NumberedSurface {
  std::vector<std::array<std::uint64_t, 3>> triangles;
  std::vector<std::uint64_t> points;
};

NumberedSurface numbered(const Survey& survey, bool interfaces) {
  NumberedSurface found;
  for (const BoundaryFace& face : survey.boundary) found.triangles.push_back(face.points);
  if (interfaces)
    for (const Interface& interface : survey.interfaces)
      for (const BoundaryFace& face : interface.faces) found.triangles.push_back(face.points);
  for (const auto& triangle : found.triangles)
    found.points.insert(found.points.end(), triangle.begin(), triangle.end());
  std::ranges::sort(found.points);
  found.points.erase(std::unique(found.points.begin(), found.points.end()), found.points.end());
  if (found.points.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorCode::too_large, "the mesh's surface has too many points to measure distances");
  return found;
}

/// `place(i)` is where the point with the i-th of the numbers is.
template <class Place>
MeshSurface with_places(const NumberedSurface& found, bool interfaces, const Place& place) {
  MeshSurface surface;
  surface.interfaces = interfaces;
  surface.points.reserve(found.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i) surface.points.push_back(place(i));
  surface.triangles.reserve(found.triangles.size());
  for (const auto& triangle : found.triangles) {
    auto& own = surface.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner)
      own[corner] = static_cast<std::uint32_t>(
          std::ranges::lower_bound(found.points, triangle[corner]) - found.points.begin());
  }
  return surface;
}

/// Where the points with some numbers are, in steps.
std::vector<Coord3> positions(const Stuffing& stuffing, const std::vector<std::uint64_t>& numbers,
                              Context& context) {
  std::vector<Coord3> positions(numbers.size());
  core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t task) {
    const auto layer = static_cast<std::int32_t>(task);
    const std::uint64_t first = stuffing.first_point(layer), end = stuffing.first_point(layer + 1);
    const auto begin = std::ranges::lower_bound(numbers, first);
    if (begin == numbers.end() || *begin >= end) return;
    std::vector<Coord3> points(static_cast<std::size_t>(end - first));
    core::OneThread own;
    stuffing.emit_points(layer, layer + 1, points, own);
    for (auto number = begin; number != numbers.end() && *number < end; ++number)
      positions[static_cast<std::size_t>(number - numbers.begin())] =
          points[static_cast<std::size_t>(*number - first)];
  });
  return positions;
}

}  // namespace

MeshSurface surface_of(const Stuffing& stuffing, const Frame& frame, Context& context) {
  const Survey found = survey(stuffing, context);
  return in_memory([&] {
    const bool interfaces = stuffing.has_interfaces();
    const NumberedSurface surface = numbered(found, interfaces);
    const std::vector<Coord3> points = positions(stuffing, surface.points, context);
    return with_places(surface, interfaces, [&](std::size_t i) { return frame.world(points[i]); });
  });
}

MeshSurface surface_of(const Mesh& mesh, Context& context) {
  const Survey found = survey(mesh, context);
  return in_memory([&] {
    const bool interfaces = !found.interfaces.empty();
    const NumberedSurface surface = numbered(found, interfaces);
    return with_places(surface, interfaces, [&](std::size_t i) {
      return mesh.frame.world(mesh.points[static_cast<std::size_t>(surface.points[i])]);
    });
  });
}

MeshSurface surface_of(std::span<const Point3> points, const Survey& survey, bool interfaces) {
  return in_memory([&] {
    const NumberedSurface surface = numbered(survey, interfaces);
    return with_places(surface, interfaces, [&](std::size_t i) {
      return points[static_cast<std::size_t>(surface.points[i])];
    });
  });
}

}  // namespace certet
