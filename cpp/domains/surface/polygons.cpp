#include "polygons.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace certet {
namespace {

using Point2 = std::array<double, 2>;

/// Twice the area of a polygon's shadow on each plane of two axes, added up.
Point3 newell_normal(std::span<const std::uint32_t> corners, const std::vector<Point3>& points) {
  Point3 normal{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3& p = points[corners[i]];
    const Point3& q = points[corners[(i + 1) % corners.size()]];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      normal[a] += (p[b] - q[b]) * (p[c] + q[c]);
    }
  }
  return normal;
}

/// A polygon seen along the axis that its normal is nearest to, anticlockwise.
class Ears {
 public:
  Ears(std::span<const std::uint32_t> corners, const std::vector<Point3>& points)
      : left_(corners.begin(), corners.end()) {
    const Point3 normal = newell_normal(corners, points);
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (std::fabs(normal[a]) > std::fabs(normal[axis])) axis = a;
    std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x, y);
    for (const std::uint32_t corner : corners)
      seen_.push_back({points[corner][x], points[corner][y]});
  }

  void cut(TriangleSurface& surface) {
    while (left_.size() > 3) take(ear(), surface);
    if (left_.size() == 3) surface.triangles.push_back({left_[0], left_[1], left_[2]});
  }

 private:
  /// Twice the area; positive to the left.
  static double turn(Point2 a, Point2 b, Point2 c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  [[nodiscard]] std::size_t before(std::size_t i) const {
    return (i + left_.size() - 1) % left_.size();
  }
  [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }

  [[nodiscard]] bool is_ear(std::size_t i) const {
    const Point2 a = seen_[before(i)], b = seen_[i], c = seen_[after(i)];
    if (!(turn(a, b, c) > 0)) return false;
    return std::none_of(seen_.begin(), seen_.end(), [&](Point2 p) {
      return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
             turn(c, a, p) >= 0;
    });
  }

  /// Every simple polygon has one; of others any corner will do.
  [[nodiscard]] std::size_t ear() const {
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (is_ear(i)) return i;
    return 1;
  }

  void take(std::size_t i, TriangleSurface& surface) {
    surface.triangles.push_back({left_[before(i)], left_[i], left_[after(i)]});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    seen_.erase(seen_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  std::vector<std::uint32_t> left_;
  std::vector<Point2> seen_;  ///< where they are
};

}  // namespace

void add_polygon(std::span<const std::uint32_t> corners, TriangleSurface& surface) {
  if (corners.size() == 3)
    surface.triangles.push_back({corners[0], corners[1], corners[2]});
  else if (corners.size() > 3)
    Ears(corners, surface.points).cut(surface);
}

}  // namespace certet
