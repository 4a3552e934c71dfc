#include <cmath>
#include <limits>

#include "certet/formats.hpp"

namespace certet {
namespace {

/// The ends of the finite coordinates along an axis.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double coordinate) {
    if (!std::isfinite(coordinate)) return;
    if (coordinate < low) low = coordinate;
    if (coordinate > high) high = coordinate;
  }

  /// The end that is nearer to 0, if 0 is farther from it than the other end: then
  /// nothing between them is more than twice it, and their difference is exact.
  [[nodiscard]] double exact_shift() const {
    if (low > 0 && high <= 2 * low) return low;
    if (high < 0 && low >= 2 * high) return high;
    return 0;
  }
};

}  // namespace

Point3 move_to_zero(FileMesh& mesh) {
  Point3 shift{};
  for (std::size_t a = 0; a < 3; ++a) {
    Range range;
    for (const Point3& point : mesh.points) range.add(point[a]);
    for (const Point3& point : mesh.middle_points) range.add(point[a]);
    shift[a] = range.exact_shift();
    // Where nothing is taken away, a negative zero stays one.
    if (shift[a] == 0) continue;
    for (Point3& point : mesh.points) point[a] -= shift[a];
    for (Point3& point : mesh.middle_points) point[a] -= shift[a];
  }
  return shift;
}

}  // namespace certet
