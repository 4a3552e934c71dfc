#pragma once
/// \file
/// The edges of a surface and the triangles along them.

#include <cstdint>
#include <vector>

#include "certet/surface.hpp"

namespace certet {

/// An edge between two points, low < high, and how many triangles run along it
/// from low to high and back.
struct SurfaceEdge {
  std::uint32_t low, high;
  std::uint32_t forward = 0, backward = 0;

  [[nodiscard]] std::uint64_t triangles() const {
    return std::uint64_t{forward} + backward;
  }
  [[nodiscard]] bool open() const { return triangles() % 2 != 0; }
  [[nodiscard]] bool overfull() const { return triangles() > 2; }
  [[nodiscard]] bool misoriented() const { return !open() && forward != backward; }
};

/// All edges once, sorted by their points.  A triangle that has a point twice has
/// no edges: what is left of it if it is taken away is as closed as before.
std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface);

/// \throws Error `bad_input` (no triangles, points that are NaN or infinite,
/// numbers of points out of range).
void refuse_malformed(const TriangleSurface& surface);

}  // namespace certet
