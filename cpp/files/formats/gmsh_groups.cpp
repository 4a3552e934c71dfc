#include "gmsh_groups.hpp"

#include <algorithm>

#include "names.hpp"

namespace certet::formats {

GmshGroups::GmshGroups(const Survey& survey) {
  const std::vector<std::string> names = names_of(survey.regions, NameRule::quoted);
  const bool positive = survey.regions.empty() || survey.regions.front().label > 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::int32_t label = survey.regions[i].label;
    regions.push_back({label, positive ? label : static_cast<std::int32_t>(i) + 1, names[i]});
  }
  for (const BoundaryFace& face : survey.boundary)
    ++patch_faces[static_cast<std::size_t>(face.patch)];
  for (const Patch patch : {Patch::surface, Patch::border})
    if (patch_faces[static_cast<std::size_t>(patch)] > 0) patches.push_back(patch);
}

std::string GmshGroups::names_section() const {
  std::string text = "$PhysicalNames\n" + std::to_string(patches.size() + regions.size()) + "\n";
  for (const Patch patch : patches)
    text.append("2 " + std::to_string(tag_of(patch)) + " \"")
        .append(patch_names[static_cast<std::size_t>(patch)])
        .append("\"\n");
  for (const Group& region : regions)
    text += "3 " + std::to_string(region.tag) + " \"" + region.name + "\"\n";
  return text + "$EndPhysicalNames\n";
}

std::int32_t GmshGroups::tag_of(std::int32_t label) const {
  const auto found = std::ranges::lower_bound(regions, label, {}, &Group::label);
  return found == regions.end() || found->label != label ? 0 : found->tag;
}

}  // namespace certet::formats
