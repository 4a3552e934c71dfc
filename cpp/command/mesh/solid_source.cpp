#include "solid_source.hpp"

#include <memory>
#include <utility>

#include "certet/gray_levels.hpp"
#include "certet/image_solids.hpp"
#include "certet/shape.hpp"
#include "certet/volume.hpp"
#include "image_source.hpp"
#include "refusal.hpp"
#include "silence.hpp"
#include "source.hpp"
#include "surface_source.hpp"

namespace certet::command {
namespace {

OpenedSolid from_surface(const SolidChoice& choice, const MeshOptions& options,
                         const Context& context) {
  CheckedSurface checked = open_surface(choice.file, options.repair, context);
  auto surface = std::make_shared<const TriangleSurface>(std::move(checked.surface));
  return {checked.open ? open_surface_solid(std::move(surface)) : surface_solid(std::move(surface)),
          std::move(checked.notes)};
}

Solid from_volume(const SolidChoice& choice, const MeshOptions& options) {
  const Silence silence;
  const std::optional<double> level = choice.iso ? std::optional(choice.iso->above) : options.iso;
  return volume_solid(read_volume(choice.file, options.grid), level);
}

/// What is between two values of the image, or above one.
OpenedSolid from_levels(Image image, const LevelRange& range) {
  OpenedSolid opened;
  opened.notes = image.notes;
  if (range.below) image = between_levels(image, {range.above, *range.below});
  opened.solid = level_solid(std::make_shared<const Image>(std::move(image)),
                             range.below ? 0 : range.above);
  return opened;
}

OpenedSolid from_labels(Image image, const std::vector<LabelRange>& labels, bool keeps_labels,
                        const MeshOptions& options, const Context& context) {
  OpenedSolid opened;
  opened.notes = image.notes;
  opened.has_labels = keeps_labels;
  if (keeps_labels) opened.names = image.names;
  else image = chosen_as_one(image, labels);
  const std::vector<LabelRange> chosen = keeps_labels ? labels : std::vector<LabelRange>{};
  const auto kept = std::make_shared<const Image>(std::move(image));
  switch (surfaces_of(options)) {
    case LabelSurfaces::flat:
      opened.solid = label_solid(kept, chosen, !facts(options.method).settles);
      break;
    case LabelSurfaces::interfaces:
      opened.solid = interface_solid(kept, chosen, {options.smooth}, context);
      break;
    case LabelSurfaces::smoothed:
      refuse("of several solids, --smooth goes with the methods that cut labels apart");
  }
  return opened;
}

OpenedSolid from_image(const SolidChoice& choice, bool keeps_labels, const MeshOptions& options,
                       std::uint64_t max_bytes, const Context& context) {
  std::optional<LevelRange> levels = choice.iso;
  if (!levels && choice.labels.empty() && options.iso) levels = {*options.iso, options.below};
  Image image = open_image(choice.file, options, levels.has_value(), max_bytes);
  OpenedSolid opened =
      levels ? from_levels(std::move(image), *levels)
             : from_labels(std::move(image),
                           choice.labels.empty() ? options.labels : choice.labels, keeps_labels,
                           options, context);
  opened.is_image = true;
  opened.axes = axes_of_file(choice.file);
  return opened;
}

}  // namespace

OpenedSolid open_solid(const SolidChoice& choice, bool keeps_labels, const MeshOptions& options,
                       std::uint64_t max_bytes, const Context& context) {
  if (!choice.formula.empty())
    return {formula_solid(whole_formula(choice.formula), options.bounds.value())};
  if (!choice.shape.empty()) return {shape_solid(choice.shape, options.bounds)};
  if (choice.is_image()) return from_image(choice, keeps_labels, options, max_bytes, context);
  if (is_volume_file(choice.file)) return {from_volume(choice, options)};
  return from_surface(choice, options, context);
}

Solid in_axes(const OpenedSolid& opened, std::optional<PatientAxes> output) {
  return output == PatientAxes::ras && !opened.is_image ? turned_over(opened.solid)
                                                        : opened.solid;
}

}  // namespace certet::command
