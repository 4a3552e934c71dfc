#pragma once
/// \file
/// Regions and patches as Gmsh's physical groups.

#include <string>
#include <vector>

#include "certet/survey.hpp"

namespace certet::formats {

/// A group's number is positive and its own among those of its dimension.
struct GmshGroups {
  explicit GmshGroups(const Survey& survey);

  /// The section $PhysicalNames.
  [[nodiscard]] std::string names_section() const;
  [[nodiscard]] std::int32_t tag_of(std::int32_t label) const;
  [[nodiscard]] static std::int32_t tag_of(Patch patch) {
    return static_cast<std::int32_t>(patch) + 1;
  }

  struct Group {
    std::int32_t label;
    std::int32_t tag;  ///< the label if all labels are positive, otherwise its rank
    std::string name;
  };
  std::vector<Group> regions;  ///< by growing labels
  std::vector<Patch> patches;  ///< that have faces
  std::array<std::uint64_t, patch_names.size()> patch_faces{};
};

}  // namespace certet::formats
