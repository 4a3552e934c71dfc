#pragma once
/// \file
/// Shapes of the world, before they are put on a lattice.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "certet/bounds.hpp"
#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"

namespace certet {

/// A shape that lies in the world but on no lattice yet, so that several can share one.
struct Solid {
  Bounds bounds;  ///< in world units; all of it is within

  /// Makes of it what the engine asks, on a lattice that holds the bounds: a domain of one
  /// material or, of labels that stay apart, of several, which may outlive the solid.  May be
  /// called for one lattice after the other.  \throws Error
  std::function<std::shared_ptr<const PlacedDomain>(const PlacedLattice&)> on;

  /// The lattice that it has alone, where it has one of its own, as the voxels of an image do;
  /// `size` and `margin` are those of `lattice_around`, but that 0 is its own choice.
  std::function<PlacedLattice(double size, std::int32_t margin)> own = {};

  /// Whether `on` takes lattices of all axes, and not of the world's alone.
  bool any_axes = false;
};

/// A solid on a lattice that holds its bounds, whatever the axes.  \throws Error, what
/// `solid.on` throws.
std::shared_ptr<const PlacedDomain> placed_on(const Solid& solid, const PlacedLattice& around);

/// The whole cells of a frame's lattice that hold a box of the world, and `margin` more on each
/// side.  \throws Error `too_large` (coordinate range).
Lattice lattice_holding(const Frame& frame, const Bounds& bounds, std::int32_t margin);

/// The lattice that a solid has alone: its own, or that around its bounds.
PlacedLattice own_lattice(const Solid& solid, double size, std::int32_t margin);

/// A solid alone.  `size` is the long edge (0: its own choice, or a 64th of the longest side),
/// `margin` the cells of the lattice around it.  \throws Error as `own_lattice`, `placed_on`.
std::shared_ptr<const PlacedDomain> solid_domain(const Solid& solid, double size = 0,
                                                 std::int32_t margin = 2);

/// Of points of the world, each taken for the nearest step of a lattice of 512 cells along the
/// longest side, 2^-26 of that: 1 in the solid or on its surface, 0 outside.
/// \throws Error what the solid throws.
std::vector<std::uint8_t> inside(const Solid& solid, std::span<const Point3> points);

}  // namespace certet
