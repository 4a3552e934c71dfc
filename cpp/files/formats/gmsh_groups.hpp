#pragma once
/// \file
/// Regions, patches and interfaces as Gmsh's physical groups.

#include <string>
#include <vector>

#include "sheets.hpp"

namespace certet::formats {

/// A group's number is positive and its own among those of its dimension.
struct GmshGroups {
  /// `survey` must live as long.
  explicit GmshGroups(const Survey& survey);

  /// $PhysicalNames, and behind it what `gmsh_label_section` has to say.
  [[nodiscard]] std::string naming_sections() const;
  [[nodiscard]] std::int32_t tag_of(std::int32_t label) const;

  struct Group {
    std::int32_t label;
    std::int32_t tag;  ///< as `gmsh_tags` has it
    std::string name;
  };
  std::vector<Group> regions;  ///< by growing labels
  Sheets sheets;               ///< the number of each is its tag
  std::string label_section;
};

}  // namespace certet::formats
