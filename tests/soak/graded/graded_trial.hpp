#pragma once
/// \file
/// A random domain, graded at random, and its mesh judged beside the uniform one.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace graded {

/// Defects that may be planted, and must be noticed.
enum class Plant : std::uint8_t {
  nothing,
  missing_tet,
  flipped_tet,     ///< two corners of a tetrahedron swapped
  other_label,     ///< of a tetrahedron inside a region
  streamed_step,   ///< the streamed mesh has one point one step off
  forgotten_size,  ///< the sizes that were asked for are not told to the engine
};
inline constexpr std::array<std::string_view, 6> plant_names{
    "nothing", "missing-tet", "flipped-tet", "other-label", "streamed-step", "forgotten-size"};

/// What became of a trial, or of many together.
struct Verdict {
  std::uint64_t tets = 0, uniform_tets = 0;
  bool several = false;    ///< materials
  bool asked = false;      ///< for sizes
  bool smaller = false;    ///< the mesh has fewer tetrahedra than the uniform one
  std::vector<std::string> faults;
};

/// Number `number` of the run with `seed`; depends on these two, and the defect, alone.
Verdict judge(std::uint64_t seed, std::uint64_t number, Plant plant);

}  // namespace graded
