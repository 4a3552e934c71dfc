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

class BorderBox {
 public:
  /// `rounding` is what a coordinate may be off by.
  BorderBox(const Point3& corner, const Point3& opposite, double rounding) : rounding_(rounding) {
    for (std::size_t a = 0; a < 3; ++a)
      std::tie(low_[a], high_[a]) = std::minmax(corner[a], opposite[a]);
  }

  [[nodiscard]] bool contains(const Point3& p) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (p[a] < low_[a] - rounding_ || p[a] > high_[a] + rounding_) return false;
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
  double rounding_;
};

/// The two lattice points that a cut in the middle of their edge lies between, in steps.
std::array<Coord3, 2> ends_of_middle(Coord3 cut) {
  const Position at{cut.x, cut.y, cut.z};
  std::array<Position, 2> ends{};
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
    ends[0][a] = steps * first;
    ends[1][a] = steps * second;
  }
  const auto point = [](const Position& p) { return Coord3{p[0], p[1], p[2]}; };
  return {point(ends[0]), point(ends[1])};
}

/// `place` maps steps to the coordinates of the box, `unit` of which are one
/// lattice unit.
template <class Place>
BorderTest border_of(const BorderBox& box, Place place, double unit, Cuts cuts) {
  if (cuts == Cuts::midpoint)
    return [box, place](Coord3 position) {
      const auto [one, other] = ends_of_middle(position);
      return box.contains(place(one)) != box.contains(place(other));
    };
  // A bisected cut is at most one step of a long edge away from the surface.
  const double tolerance = 4.0 / steps * unit;
  return [box, place, tolerance](Coord3 position) {
    return box.is_near_face(place(position), tolerance);
  };
}

/// Of the corners' positions, in lattice units.
constexpr double rounding = 1e-9;

}  // namespace

BorderTest box_border(const Frame& frame, const Point3& corner, const Point3& opposite,
                      Cuts cuts) {
  const auto place = [](Coord3 position) -> Point3 {
    constexpr double unit = 1.0 / steps;
    return {unit * position.x, unit * position.y, unit * position.z};
  };
  return border_of(
      BorderBox(lattice_position(frame, corner), lattice_position(frame, opposite), rounding), place, 1,
      cuts);
}

BorderTest world_box_border(const Frame& frame, const Point3& corner, const Point3& opposite,
                            Cuts cuts) {
  // No rounding: a point is in the box here exactly where it is in a cropped domain.
  return border_of(BorderBox(corner, opposite, 0),
                   [frame](Coord3 position) { return frame.world(position); }, frame.size / 2,
                   cuts);
}

}  // namespace certet
