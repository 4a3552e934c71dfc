#include "geometry.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "certet/error.hpp"

namespace certet {
namespace {

[[noreturn]] void refuse_geometry(const Image& image, const std::string& reason) {
  throw Error(ErrorCode::bad_input, "'" + image.name + "' " + reason);
}

/// Deviations from an orthonormal matrix up to this are taken for rounding.
constexpr double direction_tolerance = 1e-3;

/// The directions of the voxel axes.
std::array<Point3, 3> voxel_axes(const Image& image) {
  std::array<Point3, 3> column;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t r = 0; r < 3; ++r) column[a][r] = image.axes[r][a];
  return column;
}

const std::string not_orthonormal = "has a direction matrix that is not orthonormal: ";

[[noreturn]] void refuse_angle(const Image& image, const std::array<Point3, 3>& column,
                               std::size_t a, std::size_t b) {
  const double lengths = std::sqrt(dot(column[a], column[a]) * dot(column[b], column[b]));
  const double angle = std::acos(dot(column[a], column[b]) / lengths) * 180 / std::acos(-1.0);
  if (!(angle > 0.1 && angle < 179.9)) refuse_geometry(image, not_orthonormal + "it is singular");
  constexpr const char* names[3] = {"first", "second", "third"};
  std::array<char, 32> degrees{};
  std::snprintf(degrees.data(), degrees.size(), "%.1f", angle);
  refuse_geometry(image, not_orthonormal + "it has shear, for its " + names[b] + " and " +
                             names[a] + " axis meet at " + degrees.data() +
                             " degrees; resample the image on a grid with right angles");
}

}  // namespace

void check_geometry(const Image& image) {
  const auto column = voxel_axes(image);
  for (std::size_t a = 0; a < 3; ++a) {
    if (image.size[a] < 1) refuse_geometry(image, "has no voxels");
    if (!std::isfinite(image.spacing[a]) || image.spacing[a] <= 0)
      refuse_geometry(image, "has a voxel spacing that is not a positive number");
    if (!std::isfinite(image.origin[a])) refuse_geometry(image, "has an origin that is not finite");
  }
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (!(std::abs(dot(column[a], column[b])) <= direction_tolerance))
        refuse_angle(image, column, a, b);
  for (const Point3& axis : column)
    if (!(std::abs(dot(axis, axis) - 1) <= direction_tolerance))
      refuse_geometry(image, not_orthonormal + "an axis is not of length 1");
}

Image place_of(const Image& image) {
  Image place;
  place.name = image.name;
  place.size = image.size;
  place.spacing = image.spacing;
  place.origin = image.origin;
  place.axes = image.axes;
  return place;
}

/// Gram and Schmidt.
void orthonormalise(Image& image) {
  auto column = voxel_axes(image);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double along = dot(column[a], column[b]);
      for (std::size_t r = 0; r < 3; ++r) column[a][r] -= along * column[b][r];
    }
    const double length = std::sqrt(dot(column[a], column[a]));
    for (std::size_t r = 0; r < 3; ++r) column[a][r] /= length;
  }
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a) image.axes[r][a] = column[a][r] + 0.0;  // no -0
}

}  // namespace certet
