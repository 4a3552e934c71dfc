#pragma once
/// \file
/// The patches that the boundary of a mesh is divided into.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace certet {

/// What a face of the boundary is part of.  Behind these come the patches of a survey that have
/// names of their own.
enum class Patch : std::uint16_t {
  surface,  ///< the surface of the shape
  border,   ///< where the shape is cut off, by the edge of the image or the bounds, at no side
            ///< that is known
  xmin,     ///< the same, at a side of the box that is called after the axes of the output
  xmax,
  ymin,
  ymax,
  zmin,
  zmax,
};
inline constexpr std::array<std::string_view, 8> patch_names{
    "surface", "border", "xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

/// Whether a patch is where the shape is cut off.
constexpr bool is_border(Patch patch) {
  return patch != Patch::surface && static_cast<std::size_t>(patch) < patch_names.size();
}

/// Of the axes of the output; `at` in its units.
struct PatchPlane {
  std::size_t axis = 0;
  double at = 0;

  friend bool operator==(const PatchPlane&, const PatchPlane&) = default;
};

/// A patch that the user names: one that there is already, or what lies at a plane.
struct PatchChoice {
  std::string name;
  std::variant<Patch, PatchPlane> where;

  friend bool operator==(const PatchChoice&, const PatchChoice&) = default;
};

/// The choice that two words make: a name of up to 60 letters, digits and underscores, a letter
/// first, which is none of `patch_names`; and one of those, or an axis and a coordinate, "z:12.5".
/// \throws Error `bad_option`.
PatchChoice patch_choice(std::string_view name, std::string_view where);

/// The words for where it is.
std::string text_of(const std::variant<Patch, PatchPlane>& where);

}  // namespace certet
