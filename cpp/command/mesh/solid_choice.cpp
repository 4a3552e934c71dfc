#include "solid_choice.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "certet/shape.hpp"
#include "certet/surface.hpp"
#include "certet/volume.hpp"
#include "option_values.hpp"
#include "refusal.hpp"

namespace certet::command {
namespace {

bool ends_like_image(const std::string& text) {
  constexpr std::array endings{".nrrd", ".nhdr", ".nii", ".nii.gz", ".mha", ".mhd", ".tif",
                               ".tiff", ".dcm"};
  return std::ranges::any_of(endings, [&](const char* ending) { return text.ends_with(ending); });
}

bool is_file(const std::string& text) {
  std::error_code ignored;
  return is_solid_file(text) || ends_like_image(text) || std::filesystem::exists(text, ignored);
}

void refuse_misplaced_choice(const SolidChoice& solid) {
  if (!solid.labels.empty() && !solid.is_image())
    refuse("@labels=LIST goes with an image, unlike '" + solid.file.string() + "'");
  if (solid.iso && is_surface_file(solid.file))
    refuse("@iso=V goes with an image or a volume, unlike '" + solid.file.string() + "'");
  if (solid.iso && solid.iso->below && is_volume_file(solid.file))
    refuse("@iso=V takes one value with a .vdb file");
}

/// FILE@labels=LIST or FILE@iso=V; nothing where the text does not end so.
std::optional<SolidChoice> with_choice(const std::string& text) {
  constexpr std::string_view labels = "@labels=", iso = "@iso=";
  const std::size_t sign = text.rfind('@');
  if (sign == text.npos || sign == 0) return std::nullopt;
  const std::string choice = text.substr(sign);
  SolidChoice solid{text.substr(0, sign)};
  if (choice.starts_with(labels)) solid.labels = parse_labels(choice.substr(labels.size()));
  else if (choice.starts_with(iso)) solid.iso = parse_levels(choice.substr(iso.size()));
  else return std::nullopt;
  refuse_misplaced_choice(solid);
  return solid;
}

}  // namespace

bool is_solid_file(const std::filesystem::path& file) {
  return is_surface_file(file) || is_volume_file(file);
}

LevelRange parse_levels(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == text.npos) return {parse_number("--iso", text), {}};
  const std::string first = text.substr(0, dots), last = text.substr(dots + 2);
  if (first.empty() && last.empty()) refuse("--iso takes a number, A..B, A.. or ..B, not '..'");
  LevelRange range;
  range.above = first.empty() ? -std::numeric_limits<double>::infinity()
                              : parse_number("--iso", first);
  if (!last.empty()) range.below = parse_number("--iso", last);
  if (range.below && range.above >= *range.below)
    refuse("--iso takes two values that ascend, not '" + text + "'");
  return range;
}

SolidChoice parse_solid(const std::string& text) {
  SolidChoice solid;
  if (is_shape(text)) solid.shape = text;
  else if (const auto chosen = with_choice(text)) solid = *chosen;
  else if (is_file(text)) solid.file = text;
  else solid.formula = text;
  solid.text = text;
  return solid;
}

}  // namespace certet::command
