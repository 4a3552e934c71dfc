#include "source.hpp"

#include <utility>

#include "certet/error.hpp"
#include "silence.hpp"

namespace certet::command {
namespace {

Source from_formula(const MeshOptions& options) {
  Source source;
  auto domain = std::make_unique<ExpressionDomain>(options.formula, options.bounds,
                                                   options.size, options.margin);
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.border = box_border(source.frame, options.bounds.low, options.bounds.high,
                             options.stuffing.cuts);
  source.domain = std::move(domain);
  source.kind = "formula";
  source.name = options.formula;
  return source;
}

Image read(const MeshOptions& options, std::uint64_t max_bytes) {
  const Silence silence;
  return read_image(options.input, max_bytes);
}

/// The world position of a voxel's centre, or of what lies between centres.
Point3 voxel_position(const Image& image, const Point3& voxel) {
  Point3 world = image.origin;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a)
      world[r] += image.axes[r][a] * image.spacing[a] * voxel[a];
  return world;
}

Source from_image(const MeshOptions& options, std::uint64_t max_bytes) {
  Image image = read(options, max_bytes);
  if (!options.iso && !image.integral())
    throw Error(ErrorCode::bad_option, "the voxels of '" + image.name +
                                           "' are not whole numbers: choose a level with --iso");
  const ImageLattice lattice{options.size, options.margin};
  const auto [nx, ny, nz] = image.size;
  const Point3 first_corner = voxel_position(image, {-0.5, -0.5, -0.5});
  const Point3 last_corner =
      voxel_position(image, {double(nx) - 0.5, double(ny) - 0.5, double(nz) - 0.5});
  Source source;
  source.kind = options.iso ? "level" : "labels";
  source.name = image.name;
  std::unique_ptr<ImageDomain> domain =
      options.iso ? level_domain(std::move(image), *options.iso, lattice)
                  : label_domain(std::move(image), options.labels, lattice);
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.bytes = domain->bytes();
  source.border = box_border(source.frame, first_corner, last_corner, options.stuffing.cuts);
  if (!options.iso)
    source.labeller = [labels = domain.get()](std::span<const std::array<Coord3, 4>> tets,
                                               std::span<std::int32_t> out) {
      labels->label(tets, out);
    };
  source.domain = std::move(domain);
  return source;
}

}  // namespace

Source open_source(const MeshOptions& options, std::uint64_t max_bytes) {
  return options.formula.empty() ? from_image(options, max_bytes) : from_formula(options);
}

}  // namespace certet::command
