// Which points lie where a shape is cut off by a box.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "certet/survey.hpp"

namespace certet {
namespace {

using Position = std::array<std::int32_t, 3>;

/// In lattice units; what Frame::world turns round.
Point3 lattice_position(const Frame& frame, const Point3& world) {
  Point3 position{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t r = 0; r < 3; ++r)
      position[a] += 2 / frame.size * frame.axes[r][a] * (world[r] - frame.origin[r]);
  return position;
}

class Box {
 public:
  Box(const Point3& corner, const Point3& opposite) {
    for (std::size_t a = 0; a < 3; ++a)
      std::tie(low_[a], high_[a]) = std::minmax(corner[a], opposite[a]);
  }

  /// Lattice coordinates, not steps.
  [[nodiscard]] bool contains(const Point3& p) const {
    constexpr double rounding = 1e-9;
    for (std::size_t a = 0; a < 3; ++a)
      if (p[a] < low_[a] - rounding || p[a] > high_[a] + rounding) return false;
    return true;
  }

  [[nodiscard]] bool is_near_face(const Point3& p, double tolerance) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (std::abs(p[a] - low_[a]) <= tolerance || std::abs(p[a] - high_[a]) <= tolerance)
        return true;
    return false;
  }

 private:
  Point3 low_, high_;
};

/// The two lattice points that a cut in the middle of their edge lies between.
std::array<Point3, 2> ends_of_middle(Coord3 cut) {
  const Position at{cut.x, cut.y, cut.z};
  std::array<Point3, 2> ends;
  const bool is_short = at[0] % steps != 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int32_t below = at[a] >> step_bits;
    const std::int32_t others = (at[(a + 1) % 3] >> step_bits) + (at[(a + 2) % 3] >> step_bits);
    std::int32_t first = below, second = below;
    if (is_short) {
      // The first has even coordinates, the second has odd ones.
      (below % 2 == 0 ? second : first) += 1;
    } else if (others % 2 == 0 && (below ^ (at[(a + 1) % 3] >> step_bits)) % 2 != 0) {
      // A long edge runs along the axis whose parity stands alone.
      first -= 1;
      second += 1;
    }
    ends[0][a] = first;
    ends[1][a] = second;
  }
  return ends;
}

}  // namespace

BorderTest box_border(const Frame& frame, const Point3& corner, const Point3& opposite,
                      Cuts cuts) {
  const Box box(lattice_position(frame, corner), lattice_position(frame, opposite));
  if (cuts == Cuts::midpoint)
    return [box](Coord3 position) {
      const auto [one, other] = ends_of_middle(position);
      return box.contains(one) != box.contains(other);
    };
  // A bisected cut is at most one step of a long edge away from the surface.
  constexpr double tolerance = 4.0 / steps;
  return [box](Coord3 position) {
    constexpr double unit = 1.0 / steps;
    return box.is_near_face({unit * position.x, unit * position.y, unit * position.z}, tolerance);
  };
}

}  // namespace certet
