#pragma once
/// \file
/// Meshing a trial and judging the mesh by everything that is promised of it.

#include <string>
#include <string_view>
#include <vector>

#include "trial.hpp"

namespace soak {

/// Defects that may be planted in the mesh, and must be noticed.
enum class Plant {
  nothing,
  flipped_tet,    ///< two corners of a tetrahedron swapped
  missing_tet,    ///< which opens faces
  torn_point,     ///< one tetrahedron has its own copy of a point
  moved_point,
  swapped_labels,
  streamed_step,  ///< the streamed mesh has one point one step off
  half_domain,    ///< a mesh that is sound in itself, but of half the domain
  no_domain,      ///< a mesh of nothing
};
inline constexpr std::array<std::string_view, 9> plant_names{
    "nothing",     "flipped-tet",    "missing-tet",   "torn-point",
    "moved-point", "swapped-labels", "streamed-step", "half-domain", "no-domain"};

/// What became of a trial.
struct Verdict {
  Kind kind{};
  std::uint64_t tets = 0;
  double min_dihedral = 180, max_dihedral = 0;  ///< degrees
  bool fell_back = false;  ///< from the thresholds of `angles` to those of `embedding`
  bool volume_compared = false;
  bool thin = false;  ///< compared, but half of the shape or more is near its surface
  std::vector<std::string> faults;
};

Verdict verify(const Trial& trial, Plant plant);

}  // namespace soak
