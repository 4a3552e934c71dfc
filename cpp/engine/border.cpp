#include "border.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace certet {
namespace {

/// The frame by which the world's coordinates are the lattice's.
constexpr Frame lattice_frame{.size = 2};

/// Of the corners' positions, in lattice units.
constexpr double corner_rounding = 1e-9;

constexpr Sides lower(std::size_t axis) { return static_cast<Sides>(1U << (2 * axis)); }
constexpr Sides upper(std::size_t axis) { return static_cast<Sides>(2U << (2 * axis)); }

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

Sides BorderBox::sides_before(Coord3 position) const {
  const Point3 p = place_.world(position);
  Sides sides = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] < low_[a] - rounding_) sides |= lower(a);
    if (p[a] > high_[a] + rounding_) sides |= upper(a);
  }
  return sides;
}

Sides BorderBox::sides_at(Coord3 position) const {
  const double tolerance = 4.0 / steps * (place_.size / 2);
  const Point3 p = place_.world(position);
  Sides sides = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    // Of several solids others may be where the plane of a face goes on; a point of this one
    // is moved by less than an edge.
    if (p[a] < low_[a] - place_.size || p[a] > high_[a] + place_.size) return 0;
    if (std::abs(p[a] - low_[a]) <= tolerance) sides |= lower(a);
    if (std::abs(p[a] - high_[a]) <= tolerance) sides |= upper(a);
  }
  return sides;
}

std::array<std::uint8_t, side_count> BorderBox::world_sides(const Frame& frame) const {
  // Of equal ways rounding does not choose.
  constexpr double slack = 1e-9;
  std::array<std::array<double, 3>, 3> along{};  // [w][a]: of axis a of the box, in the world
  for (std::size_t w = 0; w < 3; ++w)
    for (std::size_t a = 0; a < 3; ++a)
      along[w][a] = std::inner_product(frame.axes[w].begin(), frame.axes[w].end(),
                                       place_.axes[a].begin(), 0.0);
  std::array<std::size_t, 3> way{0, 1, 2}, best = way;
  double nearest = 0;
  do {
    double near = 0;
    for (std::size_t a = 0; a < 3; ++a) near += std::abs(along[way[a]][a]);
    if (near > nearest + slack) nearest = near, best = way;
  } while (std::next_permutation(way.begin(), way.end()));
  std::array<std::uint8_t, side_count> sides{};
  for (std::size_t a = 0; a < 3; ++a) {
    const bool turned = along[best[a]][a] < 0;
    sides[2 * a] = static_cast<std::uint8_t>(2 * best[a] + (turned ? 1 : 0));
    sides[2 * a + 1] = static_cast<std::uint8_t>(2 * best[a] + (turned ? 0 : 1));
  }
  return sides;
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

namespace {

/// A cut in the middle of an edge is at the sides through which that leaves the box.
Sides sides_of(Coord3 point, const BorderBox& box, Cuts cuts) {
  if (cuts == Cuts::bisect) return box.sides_at(point);
  const auto [one, other] = ends_of_middle(point);
  const Sides before_one = box.sides_before(steps * one);
  const Sides before_other = box.sides_before(steps * other);
  return (before_one == 0) == (before_other == 0) ? Sides{0}
                                                  : static_cast<Sides>(before_one | before_other);
}

}  // namespace

bool is_on_border(Coord3 point, std::span<const BorderBox> boxes, Cuts cuts) {
  return std::ranges::any_of(boxes,
                             [&](const BorderBox& box) { return sides_of(point, box, cuts) != 0; });
}

BorderSides::BorderSides(std::span<const BorderBox> boxes, Cuts cuts, const Frame& frame)
    : cuts_(cuts) {
  for (const BorderBox& box : boxes) boxes_.push_back({box, box.world_sides(frame)});
}

Sides BorderSides::at(Coord3 point) const {
  Sides found = 0;
  for (const auto& [box, names] : boxes_) {
    const Sides sides = sides_of(point, box, cuts_);
    for (std::size_t side = 0; sides >> side != 0; ++side)
      if ((sides >> side & 1) != 0) found |= static_cast<Sides>(1U << names[side]);
  }
  return found;
}

std::size_t side_of_face(const std::array<Sides, 3>& corners) {
  std::array<int, side_count> votes{};
  for (const Sides sides : corners)
    for (std::size_t side = 0; side < side_count; ++side) votes[side] += sides >> side & 1;
  return static_cast<std::size_t>(std::ranges::max_element(votes) - votes.begin());
}

}  // namespace core
}  // namespace certet
