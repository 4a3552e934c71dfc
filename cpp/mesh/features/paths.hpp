#pragma once
/// \file
/// Jumps one behind the other, from triangle to triangle of a boundary.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jumps.hpp"

namespace certet::features {

/// A triangle across whose three edges the surface turns: three faces meet about there.
struct Junction {
  std::array<std::uint32_t, 3> jumps;  ///< of the edges from each of the corners
  std::array<std::uint32_t, 3> corners;
};

/// Jumps that follow each other.
struct Path {
  std::vector<std::uint32_t> jumps;
  std::vector<std::uint8_t> first_on_left;  ///< of jumps: on which side the first of their ends is
  bool is_loop = false;
  std::uint32_t from = none, to = none;  ///< junctions; `none` where the turn fades
};

struct Paths {
  std::vector<Junction> junctions;
  std::vector<Path> paths;
};

Paths find_paths(const SeenSurface& surface, std::span<const Jump> jumps);

}  // namespace certet::features
