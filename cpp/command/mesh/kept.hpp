#pragma once
/// \file
/// What the mesh of a run has not kept of its shape.

#include <span>

#include "certet/kept.hpp"
#include "counted.hpp"
#include "mesh_report.hpp"
#include "source.hpp"

namespace certet::command {

/// Of a mesh without tetrahedra: names a size that has some.
/// \throws Error `empty_domain`, always.
[[noreturn]] void refuse_empty(const SizedShape& shape, double size, Method method,
                               Context& context);

/// Compares a mesh that has been measured with its shape: the volume, and the pieces if none
/// were dropped.  What becomes of the voxels of an image, `RegionWatch` tells.
void tell_losses(const SizedShape& shape, const Counted& counted, Context& context,
                 MeshReport& report);

/// A size at which regions of an image have their pieces, and their solid its volume.
KeepingSizes size_for_pieces(const SizedShape& shape, const SolidVoxels& voxels,
                             std::span<const ImageRegion> regions, const MeshReport& report,
                             Context& context);

}  // namespace certet::command
