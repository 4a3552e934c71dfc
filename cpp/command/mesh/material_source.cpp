#include "material_source.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "certet/materials_domain.hpp"
#include "output_place.hpp"
#include "solid_source.hpp"

namespace certet::command {
namespace {

/// Those of the first image, if all tell theirs: then the world is the same for all.
std::optional<PatientAxes> axes_of(const std::vector<OpenedSolid>& opened) {
  std::optional<PatientAxes> axes;
  for (const OpenedSolid& one : opened) {
    if (!one.is_image) continue;
    if (!one.axes) return std::nullopt;
    if (!axes) axes = one.axes;
  }
  return axes;
}

}  // namespace

Source open_materials(const MeshOptions& options, std::uint64_t max_bytes,
                      const Context& context) {
  Source source{"materials", {}, {}};
  std::vector<OpenedSolid> opened;
  for (const MaterialChoice& one : options.materials) {
    opened.push_back(open_solid(one.solid, one.keeps_labels, options, max_bytes, context));
    source.name += (source.name.empty() ? "" : ", ") + one.name;
    std::ranges::move(opened.back().notes, std::back_inserter(source.notes));
  }
  source.axes = axes_of(opened);
  const std::optional<PatientAxes> output = output_axes(options, source);
  auto solids = std::make_shared<std::vector<NamedSolid>>();
  for (std::size_t n = 0; n < opened.size(); ++n)
    solids->push_back({options.materials[n].name, in_axes(opened[n], output),
                       opened[n].has_labels});
  source.pieces = unknown_pieces;
  source.place = [solids = std::shared_ptr<const std::vector<NamedSolid>>(std::move(solids)),
                  margin = options.margin, priority = options.priority](double size) {
    return placed(materials_domain(*solids, {size, margin}, priority));
  };
  return source;
}

}  // namespace certet::command
