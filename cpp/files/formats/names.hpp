#pragma once
/// \file
/// Names of regions, made fit for a format.

#include <string>
#include <string_view>
#include <vector>

#include "certet/survey.hpp"

namespace certet::formats {

/// What a format allows in names.
enum class NameRule {
  quoted,      ///< anything printable but quotation marks, up to 127 bytes: Gmsh
  title,       ///< the same, up to 70 bytes: LS-DYNA
  identifier,  ///< letters, digits and underscores, up to 80, a letter first: Abaqus
  xml,         ///< valid XML text, to stand in an attribute: FEBio, XDMF
};

/// A text as XML has it.
std::string escaped_xml(std::string_view text);

/// Of a region that has none: region_5, region_minus_5.
std::string default_name(std::int32_t label);

/// A name for each region, all different, even where case does not matter; those
/// that have none have their `default_name`.
std::vector<std::string> names_of(const std::vector<Region>& regions, NameRule rule);

/// A name for each patch, those of `patch_names` first; all different.
std::vector<std::string> names_of_patches(const Survey& survey, NameRule rule);

/// A name for each interface: those of its two regions, with a hyphen between them or, in an
/// identifier, an underscore; all different, and different from those of patches.
std::vector<std::string> names_of_interfaces(const Survey& survey, NameRule rule);

}  // namespace certet::formats
