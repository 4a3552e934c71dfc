#pragma once
/// \file
/// How much text the regions and sheets of a mesh need, whatever the format.

#include <cstdint>

#include "certet/survey.hpp"
#include "names.hpp"

namespace certet::formats {

/// Counts of characters, but for those of a file's own words.
struct SheetText {
  SheetText(const Survey& survey, NameRule rule);

  std::uint64_t faces = 0;            ///< of all sheets
  std::uint64_t number_digits = 0;    ///< of all faces, each the number of its sheet
  std::uint64_t label_digits = 0;     ///< of all tetrahedra, each its label
  std::uint64_t sheets = 0, regions = 0;
  std::uint64_t sheet_names = 0, region_names = 0;  ///< their characters
};

}  // namespace certet::formats
