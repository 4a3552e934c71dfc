#pragma once
/// \file
/// How much larger tetrahedra become away from the surface.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "certet/lattice/coord3.hpp"

namespace certet {

/// Up to so many levels volumes fit their numbers: `GradedVolumesFit` of the certificate.
inline constexpr std::int32_t most_grading_levels = 3;

/// Each level doubles the edges.  A cell of the lattice may be told to have fewer levels; how
/// sizes go over into each other is no choice: beside a tetrahedron are none of more than
/// twice its size.
struct Grading {
  std::int32_t levels = 0;  ///< at most; 0: all tetrahedra are of one size
  /// Of each material, from 1 on, its own most levels; those that are not told have `levels`.
  std::vector<std::int32_t> of_materials;
  /// Writes the most levels at each of some points, the centres of those cells of a layer that
  /// larger ones could fill, in lattice units; called from several threads.  None: `levels`
  /// everywhere.  `keep_within` of size_field.hpp makes one of sizes.
  std::function<void(std::span<const Coord3> points, std::span<std::int32_t> levels)> at_points;
};

}  // namespace certet
