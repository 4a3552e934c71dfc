#include "meshed_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certet/kept.hpp"

namespace certet::command {
namespace {

/// Points at which the solids are asked who has them.
constexpr std::uint64_t samples = 400'000;

bool is_missing(const MeshedMaterial& material, bool written) {
  if (written) return material.tets == 0;
  return material.pieces && material.pieces->by_faces == 0;
}

std::string why_missing(const MeshedMaterial& material, double size, bool dropped) {
  if (dropped) return "pieces were dropped";
  if (material.solid.volume == 0) return "no point was found that is in it and in no stronger one";
  return fmt::format("its volume is about {:.3g}, too small or thin for the size {:.6g}",
                     material.solid.volume, size);
}

}  // namespace

std::vector<MeshedMaterial> meshed_materials(const PlacedSource& source, const LabelNames& names,
                                             const WrittenMesh& written, const Pieces& pieces,
                                             const Context& context) {
  const std::vector<RegionPieces>& counted =
      pieces.regions.empty() ? written.region_pieces : pieces.regions;
  const std::vector<VolumeEstimate> solids =
      estimate_volumes(*source.domain, source.lattice, source.frame, samples, context);
  const double cube = std::pow(source.frame.size, 3);
  std::vector<MeshedMaterial> materials;
  for (std::size_t m = 0; m < solids.size(); ++m) {
    const std::int32_t label = source.domain->labels()[m];
    const auto name = names.find(label);
    MeshedMaterial& one = materials.emplace_back(
        MeshedMaterial{label, name == names.end() ? std::to_string(label) : name->second});
    one.solid = solids[m];
    if (const auto region = std::ranges::find(written.regions, label, &Region::label);
        region != written.regions.end()) {
      one.tets = region->tets;
      one.volume = region->volume * cube;
    }
    if (counted.empty()) continue;
    const auto found = std::ranges::find(counted, label, &RegionPieces::label);
    one.pieces = found == counted.end() ? PieceCount{} : found->pieces;
  }
  std::ranges::sort(materials, {}, &MeshedMaterial::label);
  return materials;
}

std::vector<std::string> warnings_on(const std::vector<MeshedMaterial>& materials, double size,
                                     bool written, bool dropped) {
  std::vector<std::string> sentences;
  for (const MeshedMaterial& one : materials) {
    const ShapeVolume solid{one.solid.volume, 3 * one.solid.deviation};
    if (is_missing(one, written))
      sentences.push_back(fmt::format("the material '{}' is not in the mesh: {}", one.name,
                                      why_missing(one, size, dropped)));
    else if (written && !dropped && !solid.may_be(one.volume))
      sentences.push_back(fmt::format("the mesh has {:.1f} % of the volume of the material '{}', "
                                      "{:.6g} of about {:.6g}; a smaller --size has more of it",
                                      100 * one.volume / solid.volume, one.name, one.volume,
                                      solid.volume));
  }
  return sentences;
}

}  // namespace certet::command
