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

PlacedSource placed_image(std::unique_ptr<ImageDomain> domain, bool labels) {
  const ImageDomain& image = *domain;
  PlacedSource source = placed(std::move(domain));
  if (labels)
    source.labeller = [&image](std::span<const std::array<Coord3, 4>> tets,
                               std::span<std::int32_t> out) { image.label(tets, out); };
  return source;
}

Source from_image(const MeshOptions& options, std::uint64_t max_bytes) {
  const auto image = std::make_shared<const Image>(read(options, max_bytes));
  if (!options.iso && !image->integral())
    throw Error(ErrorCode::bad_option, "the voxels of '" + image->name +
                                           "' are not whole numbers: choose a level with --iso");
  const auto place = [image, iso = options.iso, labels = options.labels,
                      margin = options.margin](double size) {
    const ImageLattice lattice{size, margin};
    return placed_image(
        iso ? level_domain(image, *iso, lattice) : label_domain(image, labels, lattice), !iso);
  };
  return {options.iso ? "level" : "labels", image->name, place, image->notes};
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
