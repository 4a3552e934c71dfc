#include "source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "certet/error.hpp"
#include "certet/gray_levels.hpp"
#include "certet/shape.hpp"
#include "certet/volume.hpp"
#include "image_source.hpp"
#include "material_source.hpp"
#include "silence.hpp"
#include "surface_source.hpp"
#include "trimmed_source.hpp"

namespace certet::command {
namespace {

Source from_formula(const MeshOptions& options) {
  const auto place = [formula = whole_formula(options.formula), bounds = options.bounds.value(),
                      margin = options.margin](double size) {
    return placed(std::make_unique<FormulaDomain>(formula, bounds, size, margin));
  };
  Source source{"formula", shortened_formula(options.formula), place};
  source.pieces = unknown_pieces;
  return source;
}

Source from_shape(const MeshOptions& options) {
  const auto place = [shape = options.shape, bounds = options.bounds,
                      margin = options.margin](double size) {
    auto domain = std::make_unique<ShapeDomain>(shape, bounds, size, margin);
    const std::optional<double> volume = domain->volume(), room = domain->room();
    PlacedSource source = placed(std::move(domain));
    source.volume = volume;
    source.room = room;
    return source;
  };
  Source source{"shape", options.shape, place};
  source.pieces = [options](Context&) {
    return ShapeDomain(options.shape, options.bounds, 0, options.margin).pieces();
  };
  return source;
}

Source from_surface(const MeshOptions& options, const Context& context) {
  CheckedSurface checked = open_surface(options.input, options.repair, context);
  const auto surface = std::make_shared<const TriangleSurface>(std::move(checked.surface));
  const auto place = [surface, margin = options.margin, volume = checked.measures.volume,
                      open = checked.open, own_size = checked.size.size](double size) {
    const SurfaceLattice lattice{size == 0 ? own_size : size, margin};
    if (open) return placed(open_surface_domain(*surface, lattice));
    PlacedSource source = placed(surface_domain(*surface, lattice));
    source.volume = volume;
    return source;
  };
  const bool own_choice =
      options.size == 0 && options.relative_size == 0 && options.target_tets == 0;
  if (own_choice && !checked.size_note.empty()) checked.notes.push_back(checked.size_note);
  Source source{"surface", surface->name, place, std::move(checked.notes)};
  source.thin = checked.measures.thin;
  source.pieces = [surface, defects = checked.defects](Context& context) {
    return pieces_of(*surface, defects, context);
  };
  return source;
}

Source from_volume(const MeshOptions& options) {
  const Silence silence;
  const auto place = [volume = read_volume(options.input, options.grid), iso = options.iso,
                      margin = options.margin](double size) {
    return placed(volume_domain(volume, iso, {size, margin}));
  };
  Source source{"volume", options.input.string(), place};
  source.pieces = unknown_pieces;
  return source;
}

/// A solid of voxels, cropped if the options want it.
PlacedSource placed_image(std::unique_ptr<PlacedDomain> domain, const MeshOptions& options) {
  return placed(options.crop ? cropped_domain(std::move(domain), *options.crop)
                             : std::move(domain));
}

/// Where no voxel is narrower than a long edge, each has a point of the lattice.
bool has_all_voxels(const Image& image, double size) {
  return size <= *std::ranges::min_element(image.spacing);
}

/// The outside alone, as one solid's.
Source from_smoothed(const std::shared_ptr<const Image>& image, const MeshOptions& options) {
  const auto smoothed = std::make_shared<const Image>(
      smoothed_labels(*image, options.labels, *options.smooth, options.run.threads));
  const auto place = [image, smoothed, options](double size) {
    return placed_image(
        smoothed_domain(image, options.labels, smoothed, {size, options.margin}), options);
  };
  Source source{"labels", image->name, place, image->notes};
  source.smoothing = Smoothing{options.smooth, volume_of_labels(*image, options.labels)};
  return source;
}

Source from_voxels(const std::shared_ptr<const Image>& image, const MeshOptions& options) {
  std::optional<double> volume;
  if (!options.iso && !options.crop) volume = volume_of_labels(*image, options.labels);
  const auto place = [image, options, volume](double size) {
    const ImageLattice lattice{size, options.margin, !facts(options.method).settles};
    PlacedSource source = placed_image(options.iso ? level_domain(image, *options.iso, lattice)
                                                   : label_domain(image, options.labels, lattice),
                                       options);
    source.volume = volume;
    source.keeps_voxels = !options.iso && has_all_voxels(*image, source.frame.size);
    return source;
  };
  return {options.iso ? "level" : "labels", image->name, place, image->notes};
}

Source from_interfaces(const std::shared_ptr<const Image>& image, const MeshOptions& options,
                       const Context& context) {
  const double volume = volume_of_labels(*image, options.labels);
  const auto fields = label_fields(image, options.labels, {options.smooth}, context);
  const auto place = [fields, options, volume, &context](double size) {
    auto domain = interface_domain(fields, {size, options.margin}, context);
    const bool keeps_voxels = domain->keeps_voxels();
    PlacedSource source = placed_image(std::move(domain), options);
    if (!options.crop) source.volume = volume;
    source.keeps_voxels = keeps_voxels;
    return source;
  };
  Source source{"labels", image->name, place, image->notes};
  source.smoothing = Smoothing{options.smooth, volume};
  return source;
}

Source from_image(const MeshOptions& asked, std::uint64_t max_bytes, const Context& context) {
  auto image = std::make_shared<const Image>(open_image(asked.input, asked, asked.iso.has_value(), max_bytes));
  MeshOptions options = asked;
  if (asked.below) {
    image = std::make_shared<const Image>(between_levels(*image, {*asked.iso, *asked.below}));
    options.iso = 0;
  }
  const LabelSurfaces surfaces = surfaces_of(options);
  const auto opened = [&] {
    switch (surfaces) {
      case LabelSurfaces::interfaces: return from_interfaces(image, options, context);
      case LabelSurfaces::smoothed: return from_smoothed(image, options);
      case LabelSurfaces::flat: break;
    }
    return from_voxels(image, options);
  };
  Source source = opened();
  if (!options.iso) source.names = image->names;
  source.axes = axes_of_file(options.input);
  source.voxels =
      SolidVoxels{image, options.labels, options.iso, surfaces, options.crop.has_value()};
  return source;
}

}  // namespace

PlacedSource placed(std::shared_ptr<const PlacedDomain> domain) {
  PlacedSource source;
  source.lattice = domain->lattice();
  source.frame = domain->frame();
  source.longest_side = domain->longest_side();
  source.bytes = domain->bytes();
  source.domain = std::move(domain);
  return source;
}

std::string whole_formula(const std::string& text) {
  return text.starts_with('@') ? read_formula(text.substr(1)) : text;
}

std::optional<PieceBounds> unknown_pieces(Context&) { return std::nullopt; }

namespace {

Source open_whole(const MeshOptions& options, std::uint64_t max_bytes, const Context& context) {
  if (!options.materials.empty()) return open_materials(options, max_bytes, context);
  if (!options.formula.empty()) return from_formula(options);
  if (!options.shape.empty()) return from_shape(options);
  if (is_surface_file(options.input)) return from_surface(options, context);
  if (is_volume_file(options.input)) return from_volume(options);
  return from_image(options, max_bytes, context);
}

}  // namespace

Source open_source(const MeshOptions& asked, std::uint64_t max_bytes, const Context& context) {
  if (asked.inside.empty() && asked.without.empty()) return open_whole(asked, max_bytes, context);
  Trimming trimming = open_trimming(asked, max_bytes, context);
  MeshOptions options = asked;
  if (!options.bounds && needs_bounds(options)) options.bounds = trimming.bounds;
  return trimmed(open_whole(options, max_bytes, context), std::move(trimming), options);
}

}  // namespace certet::command
