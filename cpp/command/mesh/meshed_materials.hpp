#pragma once
/// \file
/// What a mesh has of each of several solids.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/labels.hpp"
#include "certet/pieces.hpp"
#include "certet/volume_estimate.hpp"
#include "certet/write_mesh.hpp"
#include "source.hpp"

namespace certet::command {

/// A material, and what the mesh has of it.
struct MeshedMaterial {
  std::int32_t label = 0;
  std::string name;
  std::uint64_t tets = 0;
  double volume = 0;  ///< in world units; like `tets`, 0 after a dry run
  VolumeEstimate solid = {};  ///< what is in this solid and in no stronger one
  std::optional<PieceCount> pieces = {};  ///< where they were counted
};

/// Of all materials of a source, by their labels; who has no name is called by its number.
std::vector<MeshedMaterial> meshed_materials(const PlacedSource& source, const LabelNames& names,
                                             const WrittenMesh& written, const Pieces& pieces,
                                             const Context& context);

/// Sentences about materials that are not in the mesh, or not with the volume that they
/// have; `written` tells whether there are tetrahedra to go by, `dropped` whether pieces were
/// dropped from it.
std::vector<std::string> warnings_on(const std::vector<MeshedMaterial>& materials, double size,
                                     bool written, bool dropped);

}  // namespace certet::command
