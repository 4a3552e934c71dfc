#include "border.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace certet {
namespace {

/// The frame by which the world's coordinates are the lattice's.
constexpr Frame lattice_frame{.size = 2};

/// Of the corners' positions, in lattice units.
constexpr double corner_rounding = 1e-9;

}  // namespace

BorderBox::BorderBox(const Frame& place, const Point3& corner, const Point3& opposite,
                     double rounding)
    : place_(place), rounding_(rounding) {
  for (std::size_t a = 0; a < 3; ++a)
    std::tie(low_[a], high_[a]) = std::minmax(corner[a], opposite[a]);
}

BorderBox BorderBox::along_frame(const Frame& frame, const Point3& corner,
                                 const Point3& opposite) {
  return {lattice_frame, frame.position(corner), frame.position(opposite),
          corner_rounding};
}

BorderBox BorderBox::along_world(const Frame& frame, const Point3& corner,
                                 const Point3& opposite) {
  return {frame, corner, opposite, 0};
}

BorderBox BorderBox::seen_from(const Frame& other, const Frame& own) const {
  BorderBox box = *this;
  const Point3 origin = own.position(other.origin);
  box.place_.size *= other.size / own.size;
  box.rounding_ += corner_rounding * box.place_.size;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a) {
      box.place_.origin[r] += 0.5 * place_.size * place_.axes[r][a] * origin[a];
      box.place_.axes[r][a] = 0;
      for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t w = 0; w < 3; ++w)
          box.place_.axes[r][a] += place_.axes[r][n] * own.axes[w][n] * other.axes[w][a];
    }
  return box;
}

bool BorderBox::contains(Coord3 position) const {
  const Point3 p = place_.world(position);
  for (std::size_t a = 0; a < 3; ++a)
    if (p[a] < low_[a] - rounding_ || p[a] > high_[a] + rounding_) return false;
  return true;
}

bool BorderBox::is_at_face(Coord3 position) const {
  const double tolerance = 4.0 / steps * (place_.size / 2);
  const Point3 p = place_.world(position);
  bool at_face = false;
  for (std::size_t a = 0; a < 3; ++a) {
    // Of several solids others may be where the plane of a face goes on; a point of this one
    // is moved by less than an edge.
    if (p[a] < low_[a] - place_.size || p[a] > high_[a] + place_.size) return false;
    at_face = at_face || std::abs(p[a] - low_[a]) <= tolerance ||
              std::abs(p[a] - high_[a]) <= tolerance;
  }
  return at_face;
}

namespace core {

std::array<Coord3, 2> ends_of_middle(Coord3 middle) {
  using Position = std::array<std::int32_t, 3>;
  const Position at{middle.x, middle.y, middle.z};
  Position first{}, second{};
  const bool is_short = at[0] % steps != 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int32_t below = at[a] >> step_bits;
    const std::int32_t next = at[(a + 1) % 3] >> step_bits;
    const std::int32_t after = at[(a + 2) % 3] >> step_bits;
    first[a] = second[a] = below;
    if (is_short) {
      // The first has even coordinates, the second has odd ones.
      (below % 2 == 0 ? second : first)[a] += 1;
    } else if ((next ^ after) % 2 == 0 && (below ^ next) % 2 != 0) {
      // A long edge runs along the axis whose parity stands alone.
      first[a] -= 1;
      second[a] += 1;
    }
  }
  return {Coord3{first[0], first[1], first[2]}, Coord3{second[0], second[1], second[2]}};
}

bool is_on_border(Coord3 point, std::span<const BorderBox> boxes, Cuts cuts) {
  if (cuts == Cuts::bisect)
    return std::ranges::any_of(boxes,
                               [&](const BorderBox& box) { return box.is_at_face(point); });
  const auto [one, other] = ends_of_middle(point);
  return std::ranges::any_of(boxes, [&, one = steps * one, other = steps * other](
                                        const BorderBox& box) {
    return box.contains(one) != box.contains(other);
  });
}

}  // namespace core
}  // namespace certet
