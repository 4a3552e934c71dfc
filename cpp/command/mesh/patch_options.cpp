#include "patch_options.hpp"

#include "refusal.hpp"

namespace certet::command {

std::vector<PatchChoice> chosen_patches(const std::vector<std::string>& texts, Format format) {
  std::vector<PatchChoice> patches;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos)
      refuse("--patch is a name and where it is, like inlet=xmin or top=z:12.5, not '" + text + "'");
    patches.push_back(patch_choice(text.substr(0, equals), text.substr(equals + 1)));
  }
  if (!patches.empty() && !has_patches(format))
    refuse("--patch goes with formats that have patches, and " + std::string(name(format)) +
           " has none");
  return patches;
}

void add_patches(Lines& lines, const std::vector<PatchFigures>& patches) {
  for (const PatchFigures& patch : patches)
    lines.add("patch", "{}: {} triangles, area {:.6g}", patch.name, grouped(patch.triangles),
              patch.area);
}

Json json_of(const std::vector<PatchFigures>& patches) {
  Json all = Json::array();
  for (const PatchFigures& patch : patches)
    all.push_back({{"name", patch.name}, {"triangles", patch.triangles}, {"area", patch.area}});
  return all;
}

}  // namespace certet::command
