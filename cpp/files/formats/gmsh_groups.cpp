#include "gmsh_groups.hpp"

#include "gmsh_labels.hpp"

namespace certet::formats {

GmshGroups::GmshGroups(const Survey& survey)
    : NumberedGroups(survey), label_section_(gmsh_label_section(survey.regions)) {}

std::string GmshGroups::naming_sections() const {
  std::string text = "$PhysicalNames\n" + std::to_string(sheets.all().size() + regions.size()) + "\n";
  for (const Sheet& sheet : sheets.all())
    text += "2 " + std::to_string(sheet.number) + " \"" + sheet.name + "\"\n";
  for (const Group& region : regions)
    text += "3 " + std::to_string(region.number) + " \"" + region.name + "\"\n";
  return text + "$EndPhysicalNames\n" + label_section_;
}

}  // namespace certet::formats
