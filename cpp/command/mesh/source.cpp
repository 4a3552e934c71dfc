#include "source.hpp"

#include <utility>

#include "certet/error.hpp"
#include "certet/shape.hpp"
#include "certet/volume.hpp"
#include "silence.hpp"
#include "surface_source.hpp"

namespace certet::command {
namespace {

PlacedSource placed(std::unique_ptr<PlacedDomain> domain) {
  PlacedSource source;
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.longest_side = domain->longest_side();
  source.bytes = domain->bytes();
  source.domain = std::move(domain);
  return source;
}

Source from_formula(const MeshOptions& options) {
  const auto place = [formula = options.formula, bounds = options.bounds.value(),
                      margin = options.margin](double size) {
    return placed(std::make_unique<ExpressionDomain>(formula, bounds, size, margin));
  };
  return {"formula", options.formula, place};
}

Source from_shape(const MeshOptions& options) {
  const auto place = [shape = options.shape, bounds = options.bounds,
                      margin = options.margin](double size) {
    return placed(std::make_unique<ShapeDomain>(shape, bounds, size, margin));
  };
  return {"shape", options.shape, place};
}

Source from_surface(const MeshOptions& options) {
  JudgedSurface judged = open_surface(options.input);
  const auto surface = std::make_shared<const TriangleSurface>(std::move(judged.surface));
  const auto place = [surface, margin = options.margin](double size) {
    return placed(surface_domain(*surface, {size, margin}));
  };
  return {"surface", surface->name, place, std::move(judged.notes)};
}

Source from_volume(const MeshOptions& options) {
  const Silence silence;
  const auto place = [volume = read_volume(options.input, options.grid), iso = options.iso,
                      margin = options.margin](double size) {
    return placed(volume_domain(volume, iso, {size, margin}));
  };
  return {"volume", options.input.string(), place};
}

Image read(const MeshOptions& options, std::uint64_t max_bytes) {
  const Silence silence;
  return read_image(options.input, max_bytes, options.image);
}

PlacedSource placed_image(std::unique_ptr<ImageDomain> domain,
                          const std::optional<WorldBox>& crop, bool labels) {
  if (crop) domain = cropped_domain(std::move(domain), *crop);
  const ImageDomain& image = *domain;
  PlacedSource source = placed(std::move(domain));
  source.image = &image;
  if (labels)
    source.labeller = [&image](std::span<const std::array<Coord3, 4>> tets,
                               std::span<std::int32_t> out) { image.label(tets, out); };
  return source;
}

double chosen_volume(const Image& image, const std::vector<LabelRange>& labels) {
  std::uint64_t voxels = 0;
  for (const Region& region : regions_of_labels(image, labels)) voxels += region.voxels;
  return static_cast<double>(voxels) * image.spacing[0] * image.spacing[1] * image.spacing[2];
}

Source from_smoothed(const std::shared_ptr<const Image>& image, const MeshOptions& options) {
  const auto smoothed = std::make_shared<const Image>(
      smoothed_labels(*image, options.labels, options.smooth, options.threads));
  const auto place = [image, smoothed, options](double size) {
    return placed_image(
        smoothed_domain(image, options.labels, smoothed, {size, options.margin}), options.crop,
        true);
  };
  Source source{"labels", image->name, place, image->notes};
  source.smoothing = Smoothing{options.smooth, chosen_volume(*image, options.labels)};
  return source;
}

Source from_voxels(const std::shared_ptr<const Image>& image, const MeshOptions& options) {
  const auto place = [image, options](double size) {
    const ImageLattice lattice{size, options.margin};
    return placed_image(options.iso ? level_domain(image, *options.iso, lattice)
                                    : label_domain(image, options.labels, lattice),
                        options.crop, !options.iso);
  };
  return {options.iso ? "level" : "labels", image->name, place, image->notes};
}

Source from_image(const MeshOptions& options, std::uint64_t max_bytes) {
  const auto image = std::make_shared<const Image>(read(options, max_bytes));
  if (!options.iso && !image->integral())
    throw Error(ErrorCode::bad_option, "the voxels of '" + image->name +
                                           "' are not whole numbers: choose a level with --iso");
  Source source =
      options.smooth != 0 ? from_smoothed(image, options) : from_voxels(image, options);
  source.voxels = SolidVoxels{image, options.labels, options.iso, options.smooth != 0,
                              options.crop.has_value()};
  return source;
}

}  // namespace

Source open_source(const MeshOptions& options, std::uint64_t max_bytes) {
  if (!options.formula.empty()) return from_formula(options);
  if (!options.shape.empty()) return from_shape(options);
  if (is_surface_file(options.input)) return from_surface(options);
  if (is_volume_file(options.input)) return from_volume(options);
  return from_image(options, max_bytes);
}

}  // namespace certet::command
