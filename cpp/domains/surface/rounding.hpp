#pragma once
/// \file
/// Points of a surface, as whole numbers.

#include <cmath>
#include <vector>

#include "certet/surface.hpp"
#include "surface_box.hpp"

namespace certet {

/// Points rounded to a grid of 2^31 steps over the longest side.
class Rounding {
 public:
  explicit Rounding(const TriangleSurface& surface) {
    const SurfaceBox box(surface);
    for (std::size_t a = 0; a < 3; ++a) centre_[a] = box.low[a] + box.side(a) / 2;
    const double half = box.longest() / 2;
    if (half > 0) scale_ = 0x1p30 / half;
  }

  [[nodiscard]] Coord3 operator()(const Point3& p) const {
    const auto rounded = [&](std::size_t a) {
      return static_cast<std::int32_t>(std::lround((p[a] - centre_[a]) * scale_));
    };
    return {rounded(0), rounded(1), rounded(2)};
  }
  /// A step, in world units.
  [[nodiscard]] double step() const { return 1 / scale_; }

 private:
  Point3 centre_{};
  double scale_ = 1;
};

/// All points that triangles have; others are 0.
inline std::vector<Coord3> rounded(const TriangleSurface& surface) {
  const Rounding round(surface);
  std::vector<Coord3> points(surface.points.size(), Coord3{0, 0, 0});
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t point : triangle) points[point] = round(surface.points[point]);
  return points;
}

}  // namespace certet
