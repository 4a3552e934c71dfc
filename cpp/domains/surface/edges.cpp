#include "edges.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "certet/error.hpp"

namespace certet {

std::vector<TriangleSide> sides_of(const TriangleSurface& surface) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::uint32_t n = 0; n < surface.triangles.size(); ++n) {
    const auto& t = surface.triangles[n];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::uint8_t c = 0; c < 3; ++c) {
      const std::uint64_t from = t[c], to = t[(c + 1) % 3];
      sides.push_back({std::min(from, to) << 32 | std::max(from, to), n, c, from > to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return std::pair(a.points, a.triangle) < std::pair(b.points, b.triangle);
  });
  return sides;
}

std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface) {
  std::vector<SurfaceEdge> edges;
  edges.reserve(surface.triangles.size() / 2 * 3);
  for_each_edge(sides_of(surface), [&](std::span<const TriangleSide> sides) {
    SurfaceEdge& edge = edges.emplace_back(SurfaceEdge{sides[0].low(), sides[0].high()});
    for (const TriangleSide& side : sides) ++(side.backward ? edge.backward : edge.forward);
  });
  return edges;
}

void refuse_malformed(const TriangleSurface& surface) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::bad_input, "'" + surface.name + "' " + what);
  };
  if (surface.triangles.empty()) refuse("has no triangles");
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t point : triangle) {
      if (point >= surface.points.size())
        refuse("has a triangle with point number " + std::to_string(point) + ", but only " +
               std::to_string(surface.points.size()) + " points");
      for (const double coordinate : surface.points[point])
        if (!std::isfinite(coordinate))
          refuse("has a triangle with a point that is NaN or infinite");
    }
}

}  // namespace certet
