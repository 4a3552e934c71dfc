#include "sheets.hpp"

#include <algorithm>
#include <utility>

namespace certet::formats {

std::int32_t Sheets::first_interface(const Survey& survey) {
  const auto is_one_of_few = [](const BoundaryFace& face) { return face.patch <= Patch::border; };
  if (std::ranges::all_of(survey.boundary, is_one_of_few)) return first_of_few;
  return first_behind_sides + static_cast<std::int32_t>(survey.named_patches.size());
}

Sheets::Sheets(const Survey& survey, NameRule rule)
    : survey_(survey), first_interface_(first_interface(survey)) {
  std::vector<std::string> patches = names_of_patches(survey, rule);
  std::vector<std::uint64_t> faces(patches.size());
  for (const BoundaryFace& face : survey.boundary) ++faces[static_cast<std::size_t>(face.patch)];
  for (std::size_t patch = 0; patch < patches.size(); ++patch)
    if (faces[patch] > 0)
      all_.push_back({std::move(patches[patch]), number_of(static_cast<Patch>(patch)), faces[patch]});
  const std::vector<std::string> names = names_of_interfaces(survey, rule);
  for (std::size_t i = 0; i < names.size(); ++i)
    all_.push_back({names[i], first_interface_ + static_cast<std::int32_t>(i),
                    survey.interfaces[i].faces.size()});
}

}  // namespace certet::formats
