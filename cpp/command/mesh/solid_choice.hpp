#pragma once
/// \file
/// Solids as the command line names them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "certet/image.hpp"

namespace certet::command {

/// The values that a gray solid is between.
struct LevelRange {
  double above = 0;             ///< -infinity where there is only what is `below`
  std::optional<double> below;  ///< nothing: no end
};

/// V, A.., ..B or A..B.  \throws Error `bad_option`.
LevelRange parse_levels(const std::string& text);

/// Whether a file's name is that of a surface or volume.
bool is_solid_file(const std::filesystem::path& file);

/// A file, a formula or a shape.
struct SolidChoice {
  std::filesystem::path file = {};  ///< of these three one is not empty
  std::string formula = {}, shape = {};
  std::vector<LabelRange> labels = {};  ///< of an image; empty: as --labels says
  std::optional<LevelRange> iso = {};   ///< of an image or volume; nothing: as --iso says
  std::string text = {};                ///< as the user wrote it

  [[nodiscard]] bool is_image() const { return !file.empty() && !is_solid_file(file); }
};

/// What starts like a shape is one, what has the extension of a surface or volume is a file and so
/// is what is there; all else is a formula.  After a file there may be @labels=LIST or @iso=V.
/// \throws Error `bad_option`.
SolidChoice parse_solid(const std::string& text);

}  // namespace certet::command
