#include "gmsh_groups.hpp"

#include <algorithm>

#include "gmsh_labels.hpp"
#include "names.hpp"

namespace certet::formats {

GmshGroups::GmshGroups(const Survey& survey) : sheets(survey, NameRule::quoted) {
  const std::vector<std::string> names = names_of(survey.regions, NameRule::quoted);
  const std::vector<std::int32_t> tags = gmsh_tags(survey.regions);
  for (std::size_t i = 0; i < names.size(); ++i)
    regions.push_back({survey.regions[i].label, tags[i], names[i]});
  label_section = gmsh_label_section(survey.regions);
}

std::string GmshGroups::naming_sections() const {
  std::string text = "$PhysicalNames\n" + std::to_string(sheets.all().size() + regions.size()) + "\n";
  for (const Sheet& sheet : sheets.all())
    text += "2 " + std::to_string(sheet.number) + " \"" + sheet.name + "\"\n";
  for (const Group& region : regions)
    text += "3 " + std::to_string(region.tag) + " \"" + region.name + "\"\n";
  return text + "$EndPhysicalNames\n" + label_section;
}

std::int32_t GmshGroups::tag_of(std::int32_t label) const {
  const auto found = std::ranges::lower_bound(regions, label, {}, &Group::label);
  return found == regions.end() || found->label != label ? 0 : found->tag;
}

}  // namespace certet::formats
