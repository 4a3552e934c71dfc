#include "source.hpp"

#include <utility>

#include "certet/error.hpp"
#include "certet/volume.hpp"
#include "silence.hpp"
#include "surface_source.hpp"

namespace certet::command {
namespace {

Source from_formula(const MeshOptions& options) {
  Source source;
  auto domain = std::make_unique<ExpressionDomain>(options.formula, options.bounds,
                                                   options.size, options.margin);
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.domain = std::move(domain);
  source.kind = "formula";
  source.name = options.formula;
  return source;
}

Image read(const MeshOptions& options, std::uint64_t max_bytes) {
  const Silence silence;
  return read_image(options.input, max_bytes);
}

Source from_image(const MeshOptions& options, std::uint64_t max_bytes) {
  Image image = read(options, max_bytes);
  if (!options.iso && !image.integral())
    throw Error(ErrorCode::bad_option, "the voxels of '" + image.name +
                                           "' are not whole numbers: choose a level with --iso");
  const ImageLattice lattice{options.size, options.margin};
  Source source;
  source.kind = options.iso ? "level" : "labels";
  source.name = image.name;
  std::unique_ptr<ImageDomain> domain =
      options.iso ? level_domain(std::move(image), *options.iso, lattice)
                  : label_domain(std::move(image), options.labels, lattice);
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.bytes = domain->bytes();
  if (!options.iso)
    source.labeller = [labels = domain.get()](std::span<const std::array<Coord3, 4>> tets,
                                               std::span<std::int32_t> out) {
      labels->label(tets, out);
    };
  source.domain = std::move(domain);
  return source;
}

Source from_surface(const MeshOptions& options) {
  JudgedSurface judged = open_surface(options.input);
  auto domain = surface_domain(judged.surface, {options.size, options.margin});
  Source source;
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.bytes = domain->bytes();
  source.domain = std::move(domain);
  source.kind = "surface";
  source.name = judged.surface.name;
  source.notes = std::move(judged.notes);
  return source;
}

Source from_volume(const MeshOptions& options) {
  const auto read = [&] {
    const Silence silence;
    return read_volume(options.input, options.grid);
  };
  auto domain = volume_domain(read(), options.iso, {options.size, options.margin});
  Source source;
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.bytes = domain->bytes();
  source.domain = std::move(domain);
  source.kind = "volume";
  source.name = options.input.string();
  return source;
}

}  // namespace

Source open_source(const MeshOptions& options, std::uint64_t max_bytes) {
  if (!options.formula.empty()) return from_formula(options);
  if (is_surface_file(options.input)) return from_surface(options);
  if (is_volume_file(options.input)) return from_volume(options);
  return from_image(options, max_bytes);
}

}  // namespace certet::command
