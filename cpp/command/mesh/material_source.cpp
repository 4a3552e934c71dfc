#include "material_source.hpp"

#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "certet/materials_domain.hpp"
#include "certet/shape.hpp"
#include "certet/volume.hpp"
#include "silence.hpp"
#include "surface_source.hpp"

namespace certet::command {
namespace {

/// What is doubtful about a surface goes to `notes`.
Solid from_surface(const MaterialChoice& material, const MeshOptions& options,
                   const Context& context, std::vector<std::string>& notes) {
  CheckedSurface checked = open_surface(material.file, options.repair, context);
  std::ranges::move(checked.notes, std::back_inserter(notes));
  auto surface = std::make_shared<const TriangleSurface>(std::move(checked.surface));
  return checked.open ? open_surface_solid(std::move(surface)) : surface_solid(std::move(surface));
}

Solid from_volume(const MaterialChoice& material, const MeshOptions& options) {
  const Silence silence;
  return volume_solid(read_volume(material.file, options.grid), options.iso);
}

Solid open_solid(const MaterialChoice& material, const MeshOptions& options,
                 const Context& context, std::vector<std::string>& notes) {
  if (!material.formula.empty())
    return formula_solid(whole_formula(material.formula), options.bounds.value());
  if (!material.shape.empty()) return shape_solid(material.shape, options.bounds);
  if (is_volume_file(material.file)) return from_volume(material, options);
  return from_surface(material, options, context, notes);
}

}  // namespace

Source open_materials(const MeshOptions& options, const Context& context) {
  Source source{"materials", {}, {}};
  auto solids = std::make_shared<std::vector<NamedSolid>>();
  for (const MaterialChoice& material : options.materials) {
    source.name += (source.name.empty() ? "" : ", ") + material.name;
    solids->push_back({material.name, open_solid(material, options, context, source.notes)});
    source.names.emplace(static_cast<std::int32_t>(solids->size()), material.name);
  }
  source.pieces = unknown_pieces;
  source.place = [solids = std::shared_ptr<const std::vector<NamedSolid>>(std::move(solids)),
                  margin = options.margin, priority = options.priority](double size) {
    return placed(materials_domain(*solids, {size, margin}, priority));
  };
  return source;
}

}  // namespace certet::command
