#include <cmath>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/lattice/lattice_limits.hpp"

namespace certet {
namespace {

void check(double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw Error(ErrorCode::bad_option, "the scale is not a positive number");
}

Point3 scaled(const Point3& point, double factor) {
  const Point3 result{factor * point[0], factor * point[1], factor * point[2]};
  if (is_finite(point) && !is_finite(result))
    throw Error(ErrorCode::bad_input, "the scale takes coordinates beyond all numbers");
  return result;
}

}  // namespace

void scale(FileMesh& mesh, double factor) {
  check(factor);
  if (factor == 1) return;
  for (Point3& point : mesh.points) point = scaled(point, factor);
  for (Point3& point : mesh.middle_points) point = scaled(point, factor);
}

void scale(Mesh& mesh, double factor) {
  check(factor);
  mesh.frame.origin = scaled(mesh.frame.origin, factor);
  mesh.frame.size = checked_size(mesh.frame.size * factor);
}

}  // namespace certet
