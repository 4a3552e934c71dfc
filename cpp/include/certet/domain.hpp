#pragma once
/// \file
/// What the engine asks of the shape to be meshed.

#include <span>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/sign.hpp"

namespace certet {

/// An axis-aligned box of lattice points, both ends included, in lattice units.
struct LatticeBox {
  Coord3 low, high;
};

/// What is known of all points in a box at once.
enum class Extent { inside, outside, mixed };

/// A shape.  The engine speaks to it in lattice coordinates only; a domain that
/// lives in world coordinates keeps the `Frame` it was made with.
///
/// All calls are const, may come from several threads at once, and must give
/// the same answer for the same point every time.
class Domain {
 public:
  virtual ~Domain() = default;

  /// Signs of the lattice points first, first + (2,0,0), first + (4,0,0), …
  /// in lattice units; one for each element of `out`.
  virtual void row(Coord3 first, std::span<Sign> out) const = 0;

  /// Signs of arbitrary positions, in steps.  `out` is as long as `positions`.
  virtual void at(std::span<const Coord3> positions, std::span<Sign> out) const = 0;

  /// A bound over a box; `mixed` says nothing and is always right.
  [[nodiscard]] virtual Extent extent(const LatticeBox& box) const {
    static_cast<void>(box);
    return Extent::mixed;
  }
};

}  // namespace certet
