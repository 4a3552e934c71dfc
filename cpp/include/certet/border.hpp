#pragma once
/// \file
/// Where a shape is cut off.

#include <array>
#include <cstdint>

#include "certet/frame.hpp"
#include "certet/lattice/coord3.hpp"

namespace certet {

/// Sides of a box, a bit each: 2 a is the lower end of axis a, 2 a + 1 the upper one.
using Sides = std::uint8_t;
inline constexpr std::size_t side_count = 6;

/// A box at whose faces a shape is cut off.
class BorderBox {
 public:
  /// A box along the axes of the frame, with two opposite corners in world
  /// coordinates, in any order.  It may be off by 1e-9 lattice units.
  static BorderBox along_frame(const Frame& frame, const Point3& corner, const Point3& opposite);

  /// The same for a box along the axes of the world.  Exact: it contains those
  /// positions whose world coordinates, as `frame` gives them, are within.
  static BorderBox along_world(const Frame& frame, const Point3& corner, const Point3& opposite);

  /// The same box for positions on the lattice of another frame; this one is of `own`.
  [[nodiscard]] BorderBox seen_from(const Frame& other, const Frame& own) const;

  /// Whether a position, in steps, lies in the box.
  [[nodiscard]] bool contains(Coord3 position) const { return sides_before(position) == 0; }

  /// The sides beyond which a position, in steps, lies.
  [[nodiscard]] Sides sides_before(Coord3 position) const;

  /// The sides that a position, in steps, is at, as what bisection finds is: it is at
  /// most one step of a long edge, which is two of the lattice, away.  Twice as much
  /// is allowed for.  A long edge beyond a side its plane counts no more.
  [[nodiscard]] Sides sides_at(Coord3 position) const;
  [[nodiscard]] bool is_at_face(Coord3 position) const { return sides_at(position) != 0; }

  /// Which side of a box along the axes of the world each side is, counted in the same way: an
  /// axis of the box is called after the one of the world that is nearest to it, so that all
  /// three together are as near as they can be (of equal ways the first, in the order of axes).
  /// `frame` leads from the lattice to the world.
  [[nodiscard]] std::array<std::uint8_t, side_count> world_sides(const Frame& frame) const;

 private:
  BorderBox(const Frame& place, const Point3& corner, const Point3& opposite, double rounding);

  Frame place_;  ///< from steps to the coordinates of the box
  Point3 low_, high_;
  double rounding_;  ///< what a coordinate may be off by
};

}  // namespace certet
