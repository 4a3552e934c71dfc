#include "output_place.hpp"

#include "certet/error.hpp"

namespace certet::command {

std::optional<PatientAxes> output_axes(const MeshOptions& options, const Source& source) {
  const bool asked = options.frame == OutputFrame::lps || options.frame == OutputFrame::ras;
  if (asked && !source.axes)
    throw Error(ErrorCode::bad_option,
                "--frame cannot be had: '" + source.name +
                    "' does not tell which way its axes go in a patient");
  if (!source.axes) return std::nullopt;
  switch (options.frame) {
    case OutputFrame::ras: return PatientAxes::ras;
    case OutputFrame::input: return source.axes;
    case OutputFrame::lps:
    case OutputFrame::usual: break;
  }
  return PatientAxes::lps;
}

Frame output_frame(const MeshOptions& options, std::optional<PatientAxes> axes, Frame world) {
  if (axes == PatientAxes::ras) world = turned_over(world);
  world.size *= options.scale;
  for (double& coordinate : world.origin) coordinate *= options.scale;
  return world;
}

Frame file_frame(const MeshOptions& options, std::optional<PatientAxes> axes, const Frame& world) {
  Frame frame = output_frame(options, axes, world);
  if (options.origin == OutputOrigin::lattice) frame.origin = {0, 0, 0};
  return frame;
}

}  // namespace certet::command
