#pragma once
/// \file
/// A domain that knows where it lies.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "certet/frame.hpp"
#include "certet/labels.hpp"
#include "certet/lattice.hpp"

namespace certet {

/// The corners of a triangle, in steps.
using TriangleCorners = std::array<Coord3, 3>;

class PlacedDomain : public Domain {
 public:
  /// From lattice to world.
  [[nodiscard]] virtual const Frame& frame() const = 0;
  /// The piece of the lattice that holds the solid.
  [[nodiscard]] virtual const Lattice& lattice() const = 0;
  /// What labels are called, where that is known.
  [[nodiscard]] virtual LabelNames names() const { return {}; }
  /// Of the solid's box, in world units.
  [[nodiscard]] virtual double longest_side() const = 0;
  /// The triangles that the solid is given by, where they are all around it; else none.  Some may
  /// be within the solid.
  [[nodiscard]] virtual std::vector<TriangleCorners> triangles() const { return {}; }
  /// Triangles around the solid, to a step, where they are known: they tell its sharp edges and
  /// the faces between.  None where it is cut off, or more than one material.
  [[nodiscard]] virtual std::vector<TriangleCorners> facets() const { return triangles(); }
  /// Whether samples of a grid are all that is known of its surface: where that turns between them
  /// nothing is told.
  [[nodiscard]] virtual bool is_sampled() const { return false; }
  /// Bytes that the object holds, where they are many.
  [[nodiscard]] virtual std::uint64_t bytes() const { return 0; }
};

}  // namespace certet
