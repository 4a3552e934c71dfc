#pragma once
/// \file
/// A thin image or a random field, meshed by a method that settles and judged by independent counts.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../mesh_counts.hpp"
#include "certet/method.hpp"

namespace thin {

enum class Source : std::uint8_t { image, field };
inline constexpr std::array<std::string_view, 2> source_names{"image", "field"};

/// Defects that may be planted, and must be noticed.
enum class Plant : std::uint8_t {
  nothing,
  forgotten_rule,   ///< odd points that join groups stay inside
  three_groups,     ///< only those that join three groups or more are outside
  published_rule,   ///< violated vertices move whatever becomes of thin parts
  moved_point,      ///< of the mesh, across a neighbouring tetrahedron
};
inline constexpr std::array<std::string_view, 5> plant_names{
    "nothing", "forgotten-rule", "three-groups", "published-rule", "moved-point"};

struct Verdict : soak::MeshCounts {
  std::optional<std::string> fault;
};

/// Number `number` of the run with `seed`; depends on these two, the method and the defect, alone.
Verdict judge(Source source, std::uint64_t seed, std::uint64_t number, certet::Method method,
              Plant plant);

}  // namespace thin
