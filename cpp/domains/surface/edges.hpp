#pragma once
/// \file
/// The edges of a surface and the triangles along them.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/surface.hpp"

namespace certet {

/// The number of no point, edge, triangle or patch.
inline constexpr std::uint32_t none = 0xffffffff;

/// An edge between two points, low < high, and how many triangles run along it
/// from low to high and back.
struct SurfaceEdge {
  std::uint32_t low, high;
  std::uint32_t forward = 0, backward = 0;

  [[nodiscard]] std::uint64_t triangles() const {
    return std::uint64_t{forward} + backward;
  }
  [[nodiscard]] bool odd() const { return triangles() % 2 != 0; }
  [[nodiscard]] bool open() const { return triangles() == 1; }
  [[nodiscard]] bool overfull() const { return triangles() > 2; }
  [[nodiscard]] bool misoriented() const { return !odd() && forward != backward; }
};

/// All edges once, sorted by their points.  A triangle that has a point twice has
/// no edges: what is left of it if it is taken away is as closed as before.
std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface);

/// One side of one triangle: from its corner `corner` to the next.
struct TriangleSide {
  std::uint64_t points;    ///< the lower number in the upper half
  std::uint32_t triangle;
  std::uint8_t corner;
  bool backward;           ///< from the higher number to the lower

  [[nodiscard]] std::uint32_t low() const { return static_cast<std::uint32_t>(points >> 32); }
  [[nodiscard]] std::uint32_t high() const { return static_cast<std::uint32_t>(points); }
};

/// Sorted by their points, those of an edge in the order of the triangles.
std::vector<TriangleSide> sides_of(const TriangleSurface& surface);

/// Calls visit(sides) once for each edge, with the sides along it.
template <class Visit>
void for_each_edge(std::span<const TriangleSide> sides, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].points == sides[begin].points) ++end;
    visit(sides.subspan(begin, end - begin));
  }
}

/// \throws Error `bad_input` (no triangles, points that are NaN or infinite,
/// numbers of points out of range).
void refuse_malformed(const TriangleSurface& surface);

}  // namespace certet
