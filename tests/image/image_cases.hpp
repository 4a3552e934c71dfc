#pragma once
/// \file
/// Small images of every direction, and what is known of the domains in them, found again
/// from world coordinates and the voxels around.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/image.hpp"

namespace certet::image_cases {

inline constexpr unsigned seed = 20070;


using Axes = std::array<std::array<double, 3>, 3>;

inline const std::vector<Axes> all_axes{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},            // plain
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},           // left-handed
    {{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}},           // permuted, left-handed
    {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}}};  // turned

/// Blobs of value 0..3, some blocks of 8 uniform, most not.
template <class T>
Image blobs(const Axes& axes, const Point3& spacing) {
  Image image;
  image.name = "blobs";
  image.size = {19, 11, 26};
  image.spacing = spacing;
  image.origin = {5, -7, 11};
  image.axes = axes;
  Buffer<T> voxels(static_cast<std::size_t>(19 * 11 * 26));
  std::size_t at = 0;
  for (int k = 0; k < 26; ++k)
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 19; ++i)
        voxels[at++] = static_cast<T>(k < 8 ? 2 : k < 16 ? 0 : (i * i + 3 * j * k) / 17 % 4);
  image.voxels = std::move(voxels);
  return image;
}

template <class T>
double voxel(const Image& image, std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto& voxels = std::get<Buffer<T>>(image.voxels);
  return static_cast<double>(
      voxels[static_cast<std::size_t>((k * image.size[1] + j) * image.size[0] + i)]);
}

/// Voxel coordinates of a world point.
inline Point3 in_voxels(const Image& image, const Point3& world) {
  Point3 result;
  for (std::size_t a = 0; a < 3; ++a) {
    result[a] = 0;
    for (std::size_t r = 0; r < 3; ++r)
      result[a] += (world[r] - image.origin[r]) * image.axes[r][a] / image.spacing[a];
  }
  return result;
}

inline bool beyond(const Image& image, const Point3& at) {
  for (std::size_t a = 0; a < 3; ++a)
    if (at[a] < -0.5 || at[a] > static_cast<double>(image.size[a]) - 0.5) return true;
  return false;
}

/// Whether rounding may decide which voxel is nearest, or what is beyond.
inline bool ties(const Point3& at) {
  return std::any_of(at.begin(), at.end(), [](double c) {
    return std::abs(c - std::floor(c) - 0.5) < 1e-9;
  });
}

inline double trilinear(const Image& image, const Point3& at) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::int64_t, 3> n;
    for (std::size_t a = 0; a < 3; ++a) {
      const double last = static_cast<double>(image.size[a] - 1);
      const double c = std::clamp(at[a], 0.0, last);
      const double low = std::min(std::floor(c), last - 1);
      const bool high = (corner >> a) & 1;
      weight *= high ? c - low : 1 - (c - low);
      n[a] = static_cast<std::int64_t>(low) + (high ? 1 : 0);
    }
    sum += weight * voxel<float>(image, n[0], n[1], n[2]);
  }
  return sum;
}

/// Whether a point is among the outermost of its lattice, which the engine takes
/// for outside.
inline bool on_rim(const Lattice& lattice, Coord3 point) {
  const auto rim = [](std::int32_t cells, std::int32_t at) {
    return at < 2 || at >= 2 * cells - 2;
  };
  return rim(lattice.cells[0], point.x - lattice.origin.x) ||
         rim(lattice.cells[1], point.y - lattice.origin.y) ||
         rim(lattice.cells[2], point.z - lattice.origin.z);
}

/// Calls visit(lattice point, sign by row) for all points of a domain's lattice.
template <class Visit>
void for_all_points(const PlacedDomain& domain, const Visit& visit) {
  const Lattice& lattice = domain.lattice();
  std::vector<Sign> row(static_cast<std::size_t>(lattice.cells[0]));
  for (int odd = 0; odd < 2; ++odd)
    for (int k = 0; k < lattice.cells[2]; ++k)
      for (int j = 0; j < lattice.cells[1]; ++j) {
        const Coord3 first = lattice.origin + Coord3{odd, 2 * j + odd, 2 * k + odd};
        domain.row(first, row);
        for (int i = 0; i < lattice.cells[0]; ++i)
          visit(first + Coord3{2 * i, 0, 0}, row[static_cast<std::size_t>(i)]);
      }
}

inline Sign sign_at(const PlacedDomain& domain, Coord3 position) {
  Sign sign{};
  domain.at({&position, 1}, {&sign, 1});
  return sign;
}

struct Case {
  Axes axes;
  Point3 spacing;
  double size;
};

inline std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Axes& axes : all_axes)
    for (const double size : {1.0, 0.37, 0.5, 1.5, 2.0}) all.push_back({axes, {1, 1, 1}, size});
  for (const Axes& axes : all_axes) all.push_back({axes, {0.5, 1, 2}, 0.5});
  return all;
}

}  // namespace certet::image_cases
