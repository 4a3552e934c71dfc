#include "source.hpp"

#include <utility>

#include "certet/error.hpp"
#include "certet/shape.hpp"
#include "silence.hpp"

namespace certet::command {
namespace {

/// Of any domain that knows its frame and lattice.
template <class PlacedDomain>
PlacedSource placed(std::unique_ptr<PlacedDomain> domain, double longest_side) {
  PlacedSource source;
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.longest_side = longest_side;
  source.domain = std::move(domain);
  return source;
}

Source from_formula(const MeshOptions& options) {
  const auto place = [formula = options.formula, bounds = options.bounds.value(),
                      margin = options.margin](double size) {
    return placed(std::make_unique<ExpressionDomain>(formula, bounds, size, margin),
                  longest_side(bounds));
  };
  return {"formula", options.formula, place};
}

Source from_shape(const MeshOptions& options) {
  const auto place = [shape = options.shape, bounds = options.bounds,
                      margin = options.margin](double size) {
    auto domain = std::make_unique<ShapeDomain>(shape, bounds, size, margin);
    const double side = longest_side(domain->bounds());
    return placed(std::move(domain), side);
  };
  return {"shape", options.shape, place};
}

Image read(const MeshOptions& options, std::uint64_t max_bytes) {
  const Silence silence;
  return read_image(options.input, max_bytes);
}

PlacedSource placed_image(std::unique_ptr<ImageDomain> domain, bool labels) {
  const ImageDomain& image = *domain;
  PlacedSource source = placed(std::move(domain), image.longest_side());
  source.bytes = image.bytes();
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
  return {options.iso ? "level" : "labels", image->name, place};
}

}  // namespace

Source open_source(const MeshOptions& options, std::uint64_t max_bytes) {
  if (!options.formula.empty()) return from_formula(options);
  if (!options.shape.empty()) return from_shape(options);
  return from_image(options, max_bytes);
}

}  // namespace certet::command
