#include "certet/quality.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace certet {
namespace {

std::string degrees(double angle) {
  std::array<char, 40> text;
  // As many digits as are checked, but none that are zeros at the end.
  angle = std::round(angle * 1000) / 1000;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), angle).ptr};
}

}  // namespace

bool within(const Quality& quality, const AngleBounds& bounds, double rounding) {
  return quality.nonpositive == 0 && quality.min_dihedral >= bounds.min_dihedral - rounding &&
         quality.max_dihedral <= bounds.max_dihedral + rounding;
}

std::string angle_defect(const Quality& world, const AngleBounds& bounds,
                         std::string_view whose) {
  if (world.tets == world.nonpositive ||
      (world.min_dihedral >= bounds.min_dihedral - shown_rounding &&
       world.max_dihedral <= bounds.max_dihedral + shown_rounding))
    return {};
  return "the dihedral angles are from " + degrees(world.min_dihedral) + " to " +
         degrees(world.max_dihedral) + " degrees, outside of the " +
         degrees(bounds.min_dihedral) + " to " + degrees(bounds.max_dihedral) + " of " +
         std::string(whose);
}

}  // namespace certet
