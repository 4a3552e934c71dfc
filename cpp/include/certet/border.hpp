#pragma once
/// \file
/// Where a shape is cut off.

#include "certet/frame.hpp"
#include "certet/lattice/coord3.hpp"

namespace certet {

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
  [[nodiscard]] bool contains(Coord3 position) const;

  /// Whether a position, in steps, is at a face, as what bisection finds is: it is at
  /// most one step of a long edge, which is two of the lattice, away.  Twice as much
  /// is allowed for.  A long edge beyond a face its plane counts no more.
  [[nodiscard]] bool is_at_face(Coord3 position) const;

 private:
  BorderBox(const Frame& place, const Point3& corner, const Point3& opposite, double rounding);

  Frame place_;  ///< from steps to the coordinates of the box
  Point3 low_, high_;
  double rounding_;  ///< what a coordinate may be off by
};

}  // namespace certet
