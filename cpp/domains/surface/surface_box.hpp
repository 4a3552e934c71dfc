#pragma once
/// \file
/// The box around a surface.

#include <algorithm>
#include <cmath>

#include "certet/surface.hpp"

namespace certet {

/// Around the points of the triangles, in world units.
struct SurfaceBox {
  Point3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};

  explicit SurfaceBox(const TriangleSurface& surface) {
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t point : triangle)
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], surface.points[point][a]);
          high[a] = std::max(high[a], surface.points[point][a]);
        }
  }
  [[nodiscard]] double side(std::size_t a) const { return high[a] - low[a]; }
  [[nodiscard]] Point3 sides() const { return {side(0), side(1), side(2)}; }
  [[nodiscard]] double longest() const { return std::max({side(0), side(1), side(2)}); }
};

}  // namespace certet
