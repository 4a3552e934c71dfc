#include "edges.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "certet/error.hpp"

namespace certet {
namespace {

/// One side of one triangle, its points in order.
struct Side {
  std::uint64_t points;
  bool backward;
};

std::vector<Side> sides_of(const TriangleSurface& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (const auto& t : surface.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t from = t[c], to = t[(c + 1) % 3];
      sides.push_back({std::min(from, to) << 32 | std::max(from, to), from > to});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.points < b.points; });
  return sides;
}

}  // namespace

std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface) {
  std::vector<SurfaceEdge> edges;
  edges.reserve(surface.triangles.size() / 2 * 3);
  for (const Side& side : sides_of(surface)) {
    const auto low = static_cast<std::uint32_t>(side.points >> 32);
    const auto high = static_cast<std::uint32_t>(side.points);
    if (edges.empty() || edges.back().low != low || edges.back().high != high)
      edges.push_back({low, high});
    ++(side.backward ? edges.back().backward : edges.back().forward);
  }
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
