#pragma once
/// \file
/// Points of a surface, as whole numbers.

#include <algorithm>
#include <cmath>

#include "certet/surface.hpp"

namespace certet {

/// Points rounded to a grid of 2^31 steps over the longest side.
class Rounding {
 public:
  explicit Rounding(const TriangleSurface& surface) {
    Point3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t point : triangle)
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], surface.points[point][a]);
          high[a] = std::max(high[a], surface.points[point][a]);
        }
    double half = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      centre_[a] = low[a] + (high[a] - low[a]) / 2;
      half = std::max(half, (high[a] - low[a]) / 2);
    }
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

}  // namespace certet
