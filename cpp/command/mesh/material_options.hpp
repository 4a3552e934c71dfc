#pragma once
/// \file
/// The options that make several solids the materials of one mesh.

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "solid_choice.hpp"

namespace certet::command {

/// One of several solids.
struct MaterialChoice {
  std::string name;
  SolidChoice solid;
  bool keeps_labels = false;  ///< those of an image, unless it is gray
};

/// As the user wrote them.
struct RawMaterials {
  std::vector<std::string> definitions;  ///< NAME=FORMULA, NAME=SHAPE or NAME=FILE
  std::string priority;
  std::vector<std::string> inside, without;  ///< FORMULA, SHAPE or FILE
};

/// Declares `--material`, `--priority`, `--inside` and `--subtract`.
void declare_materials(CLI::App& app, RawMaterials& raw);

/// The files, which are called after their names, and then those of `--material`; none of
/// a single file.  \throws Error `bad_option`.
std::vector<MaterialChoice> chosen_materials(const std::vector<std::filesystem::path>& files,
                                             const RawMaterials& raw);

/// What `--inside` or `--subtract` names.  \throws Error `bad_option`.
std::vector<SolidChoice> chosen_solids(const std::vector<std::string>& texts);

/// The names in `--priority`, the strongest first, which are those of materials.
/// \throws Error `bad_option`.
std::vector<std::string> chosen_priority(const std::vector<MaterialChoice>& materials,
                                         const RawMaterials& raw);

}  // namespace certet::command
