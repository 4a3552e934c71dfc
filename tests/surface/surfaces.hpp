#pragma once
/// \file
/// Closed surfaces to try.

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/surface.hpp"

namespace surfaces {

using certet::Point3;
using certet::TriangleSurface;

inline TriangleSurface box(Point3 low, Point3 high) {
  TriangleSurface result{"box", {}, {}};
  for (unsigned corner = 0; corner < 8; ++corner)
    result.points.push_back({corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                             corner & 4 ? high[2] : low[2]});
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    result.triangles.push_back({a, b, c});
    result.triangles.push_back({a, c, d});
  }
  return result;
}

/// Meridians and parallels, with poles on the z axis.
inline TriangleSurface ball(Point3 centre, double radius, std::uint32_t around = 40,
                            std::uint32_t along = 20) {
  TriangleSurface result{"ball", {}, {}};
  const double pi = std::acos(-1.0);
  const auto add = [&](double polar, double azimuth) {
    result.points.push_back({centre[0] + radius * std::sin(polar) * std::cos(azimuth),
                             centre[1] + radius * std::sin(polar) * std::sin(azimuth),
                             centre[2] + radius * std::cos(polar)});
  };
  for (std::uint32_t j = 1; j < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) add(pi * j / along, 2 * pi * i / around);
  add(0, 0);
  add(pi, 0);
  const std::uint32_t north = (along - 1) * around, south = north + 1;
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t k = (i + 1) % around;
    result.triangles.push_back({north, i, k});
    result.triangles.push_back({south, (along - 2) * around + k, (along - 2) * around + i});
    for (std::uint32_t j = 0; j + 2 < along; ++j) {
      const std::uint32_t row = j * around, next = row + around;
      result.triangles.push_back({row + i, next + i, next + k});
      result.triangles.push_back({row + i, next + k, row + k});
    }
  }
  return result;
}

inline TriangleSurface inside_out(TriangleSurface surface) {
  for (auto& [a, b, c] : surface.triangles) std::swap(b, c);
  return surface;
}

inline TriangleSurface both(TriangleSurface first, const TriangleSurface& second) {
  const auto shift = static_cast<std::uint32_t>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const auto& [a, b, c] : second.triangles)
    first.triangles.push_back({a + shift, b + shift, c + shift});
  return first;
}

}  // namespace surfaces
