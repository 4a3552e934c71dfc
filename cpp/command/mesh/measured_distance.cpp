#include "measured_distance.hpp"

namespace certet::command {
namespace {

/// What the shape's surface is, as the end of a sentence.
std::string surface_of(const Source& source, bool exact) {
  if (exact) return "its triangles, exactly";
  if (source.voxels && !source.voxels->level) switch (source.voxels->surfaces) {
      case LabelSurfaces::interfaces: return "where the greatest of the labels' smooth fields changes";
      case LabelSurfaces::smoothed: return "that of the smoothed labels";
      case LabelSurfaces::flat: return "the faces of voxels";
    }
  if (source.kind == "level" || source.kind == "volume")
    return "where the values, interpolated between voxels, pass the level";
  if (source.kind == "formula") return "where the formula changes its sign";
  return "where the inside ends, as the lattice's steps tell";
}

}  // namespace

DistanceReport measured_distance(const Source& source, const Counted& counted, const Mesh* moved,
                                 const Frame& output, Context& context) {
  const Frame& frame = counted.source.frame;
  const MeshSurface mesh = moved != nullptr
                               ? certet::surface_of(*moved, context)
                               : certet::surface_of(counted.stuffing, frame, context);
  DistanceReport report{measure_distance(mesh, *counted.source.domain, context), {}};
  for (Distance* one : {&report.figures.to_shape, &report.figures.to_mesh})
    one->at = output.world_at(frame.position(one->at));
  report.against = surface_of(source, report.figures.exact);
  return report;
}

}  // namespace certet::command
