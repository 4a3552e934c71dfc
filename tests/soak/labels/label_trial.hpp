#pragma once
/// \file
/// A random domain of several labels, meshed, and its mesh judged without the engine's code.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../mesh_counts.hpp"

namespace labelled {

/// Defects that may be planted, and must be noticed.
enum class Plant : std::uint8_t {
  nothing,
  flipped_tet,     ///< two corners of a tetrahedron swapped
  moved_point,     ///< across a neighbouring tetrahedron
  missing_tet,     ///< from the inside of a region
  other_label,     ///< of a tetrahedron inside a region
  torn_interface,  ///< one region has points of its own
  lost_label,      ///< a region goes to another one
  lone_sample,     ///< a lattice point inside a region is of another one
  streamed_step,   ///< the streamed mesh has one point one step off
};
inline constexpr std::array<std::string_view, 9> plant_names{
    "nothing",     "flipped-tet",    "moved-point", "missing-tet",  "other-label",
    "torn-interface", "lost-label", "lone-sample", "streamed-step"};

/// What became of a trial, or of many together.
struct Verdict : soak::MeshCounts {  ///< pieces, tunnels and cavities of all regions
  std::uint64_t meshes = 1, regions = 0, interfaces = 0;
  std::uint64_t joined = 0;    ///< pieces of smoothed voxels that hang together at a distance
  std::uint64_t lost = 0;      ///< labels that are not in the mesh, and are named
  std::uint64_t streamed = 0;  ///< meshes that were compared with the same one, streamed
  /// Points in which a region touches itself, and the surface of all together.
  std::uint64_t region_pinches = 0, outer_pinches = 0;
  std::uint64_t parted = 0;  ///< pieces of all together by faces that hang together in points
  std::vector<std::string> faults;
};

/// Number `number` of the run with `seed`; depends on these two, and the defect, alone.
Verdict judge(std::uint64_t seed, std::uint64_t number, Plant plant);

}  // namespace labelled
