#pragma once
/// \file
/// Regions, patches and interfaces as Gmsh's physical groups.

#include <string>

#include "numbered_groups.hpp"

namespace certet::formats {

struct GmshGroups : NumberedGroups {
  /// `survey` must live as long.
  explicit GmshGroups(const Survey& survey);

  /// $PhysicalNames, and behind it what `gmsh_label_section` has to say.
  [[nodiscard]] std::string naming_sections() const;

 private:
  std::string label_section_;
};

}  // namespace certet::formats
