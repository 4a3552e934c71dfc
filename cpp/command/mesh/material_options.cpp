#include "material_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "refusal.hpp"

namespace certet::command {
namespace {

MaterialChoice of_definition(const std::string& text) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos || equal == 0 || equal + 1 == text.size())
    refuse("--material takes NAME=FORMULA, NAME=SHAPE or NAME=FILE, not '" + text + "'");
  return {text.substr(0, equal), parse_solid(text.substr(equal + 1))};
}

/// What comes before the first dot of "labels.nii.gz", and the last of "a.b.stl".
std::string name_of(const std::filesystem::path& file) {
  std::filesystem::path stem = file.stem();
  if (file.extension() == ".gz") stem = stem.stem();
  return stem.empty() ? file.parent_path().filename().string() : stem.string();
}

void check_names(const std::vector<MaterialChoice>& materials) {
  for (auto one = materials.begin(); one != materials.end(); ++one) {
    if (one->name.find(',') != std::string::npos)
      refuse("the name of a material has no comma, unlike '" + one->name + "'");
    const auto other = std::find_if(materials.begin(), one, [&](const MaterialChoice& before) {
      return before.name == one->name;
    });
    if (other != one)
      refuse("two materials are called '" + one->name + "'; --material NAME=FILE gives a file "
             "another name");
  }
}

}  // namespace

void declare_materials(CLI::App& app, RawMaterials& raw) {
  app.add_option("--material", raw.definitions,
                 "A solid among several, each a material of its own, after those of INPUT: where "
                 "a formula is negative (within --bounds), a shape, or a file; of an image all "
                 "labels, some (FILE@labels=LIST) or what is gray (FILE@iso=V); repeatable")
      ->option_text("NAME=SOLID")
      ->allow_extra_args(false);
  app.add_option("--priority", raw.priority,
                 "Of several solids, whose material is where they overlap: names, the strongest "
                 "first (default: the last solid is the strongest)")
      ->option_text("NAME,NAME,...");
  app.add_option("--inside", raw.inside,
                 "Of all that is meshed, what is in this solid, too: a file, a shape or a formula "
                 "as --material has them; repeatable")
      ->option_text("SOLID")
      ->allow_extra_args(false);
  app.add_option("--subtract", raw.without,
                 "Of all that is meshed, what is not in this solid; repeatable")
      ->option_text("SOLID")
      ->allow_extra_args(false);
}

std::vector<SolidChoice> chosen_solids(const std::vector<std::string>& texts) {
  std::vector<SolidChoice> solids;
  for (const std::string& text : texts) solids.push_back(parse_solid(text));
  return solids;
}

std::vector<MaterialChoice> chosen_materials(const std::vector<std::filesystem::path>& files,
                                             const RawMaterials& raw) {
  std::vector<MaterialChoice> materials;
  if (files.size() > 1 || !raw.definitions.empty())
    for (const std::filesystem::path& file : files)
      materials.push_back({name_of(file), {file}, !is_solid_file(file)});
  for (const std::string& text : raw.definitions) materials.push_back(of_definition(text));
  check_names(materials);
  return materials;
}

std::vector<std::string> chosen_priority(const std::vector<MaterialChoice>& materials,
                                         const RawMaterials& raw) {
  std::vector<std::string> names;
  if (raw.priority.empty()) return names;
  if (materials.empty()) refuse("--priority goes with several solids");
  for (std::size_t begin = 0; begin <= raw.priority.size();) {
    const std::size_t end = std::min(raw.priority.find(',', begin), raw.priority.size());
    names.push_back(raw.priority.substr(begin, end - begin));
    begin = end + 1;
    if (std::ranges::find(materials, names.back(), &MaterialChoice::name) == materials.end())
      refuse("--priority: no material is called '" + names.back() + "'");
    if (std::ranges::count(names, names.back()) > 1)
      refuse("--priority names '" + names.back() + "' twice");
  }
  return names;
}

}  // namespace certet::command
