#include "sheets.hpp"

#include <algorithm>

namespace certet::formats {

Sheets::Sheets(const Survey& survey, NameRule rule) : survey_(survey) {
  for (const Patch patch : {Patch::surface, Patch::border}) {
    const auto faces = std::ranges::count(survey.boundary, patch, &BoundaryFace::patch);
    if (faces > 0)
      all_.push_back({std::string(patch_names[static_cast<std::size_t>(patch)]), number_of(patch),
                      static_cast<std::uint64_t>(faces)});
  }
  const std::vector<std::string> names = names_of_interfaces(survey, rule);
  for (std::size_t i = 0; i < names.size(); ++i)
    all_.push_back({names[i], first_interface + static_cast<std::int32_t>(i),
                    survey.interfaces[i].faces.size()});
}

}  // namespace certet::formats
