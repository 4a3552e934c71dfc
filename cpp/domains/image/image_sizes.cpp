#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <sstream>
#include <utility>

#include "certet/error.hpp"
#include "certet/size_fields.hpp"
#include "geometry.hpp"

namespace certet {
namespace {

[[noreturn]] void refuse_beyond(const Image& image, const Point3& at) {
  std::ostringstream sentence;
  sentence.precision(9);
  sentence << "the size field, image '" << image.name << "', does not cover the shape: (" << at[0]
           << ", " << at[1] << ", " << at[2] << ") is beyond it";
  throw Error(ErrorCode::bad_input, sentence.str());
}

/// A place along an axis: the voxels that it lies between, and how far from the first.
struct VoxelPair {
  std::array<std::size_t, 2> voxels;
  double weight;
};

/// Half a voxel beyond the outermost centres they go on as they are.
bool is_covered(double at, std::int64_t count) {
  constexpr double rounding = 1e-9;
  return at >= -0.5 - rounding && at <= static_cast<double>(count) - 0.5 + rounding;
}

VoxelPair pair_at(double at, std::int64_t count) {
  const double last = static_cast<double>(count - 1);
  const double within = std::clamp(at, 0.0, last);
  const double first = std::min(std::floor(within), std::max(last - 1, 0.0));
  const auto voxel = static_cast<std::size_t>(first);
  return {{voxel, std::min(voxel + 1, static_cast<std::size_t>(count - 1))}, within - first};
}

template <class T>
double interpolated(const Image& image, const Buffer<T>& voxels, const std::array<VoxelPair, 3>& at) {
  const auto nx = static_cast<std::size_t>(image.size[0]);
  const auto ny = static_cast<std::size_t>(image.size[1]);
  const auto& [x, y, z] = at;
  std::array<double, 2> planes{};
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<double, 2> rows{};
    for (std::size_t j = 0; j < 2; ++j) {
      const T* const row = &voxels[(z.voxels[k] * ny + y.voxels[j]) * nx];
      rows[j] = std::lerp(static_cast<double>(row[x.voxels[0]]),
                          static_cast<double>(row[x.voxels[1]]), x.weight);
    }
    planes[k] = std::lerp(rows[0], rows[1], y.weight);
  }
  return std::lerp(planes[0], planes[1], z.weight);
}

template <class T>
double size_at(const Image& image, const Buffer<T>& voxels, const Point3& point) {
  std::array<VoxelPair, 3> place;
  for (std::size_t a = 0; a < 3; ++a) {
    double along = 0;
    for (std::size_t r = 0; r < 3; ++r) along += (point[r] - image.origin[r]) * image.axes[r][a];
    along /= image.spacing[a];
    if (!is_covered(along, image.size[a])) refuse_beyond(image, point);
    place[a] = pair_at(along, image.size[a]);
  }
  return interpolated(image, voxels, place);
}

}  // namespace

SizeField image_sizes(Image image) {
  check_geometry(image);
  orthonormalise(image);
  return {"image '" + image.name + "'",
          [image = std::make_shared<const Image>(std::move(image))](
              std::span<const Point3> points, std::span<double> out) {
            std::visit(
                [&](const auto& voxels) {
                  for (std::size_t i = 0; i < points.size(); ++i)
                    out[i] = size_at(*image, voxels, points[i]);
                },
                image->voxels);
          }};
}

}  // namespace certet
