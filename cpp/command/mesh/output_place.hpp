#pragma once
/// \file
/// In which coordinates a mesh goes out.

#include <optional>

#include "certet/patient_axes.hpp"
#include "source.hpp"

namespace certet::command {

/// Which way the axes of the output go, where that is known.
/// \throws Error `bad_option` where --frame asks for some and the input does not tell its own.
std::optional<PatientAxes> output_axes(const MeshOptions& options, const Source& source);

/// The frame of the output, for --frame and --scale; its origin is that of the lattice in the
/// coordinates of the output, without --origin 0.
Frame output_frame(const MeshOptions& options, std::optional<PatientAxes> axes, Frame world);

/// The same with --origin 0, too: that of what goes to the file.
Frame file_frame(const MeshOptions& options, std::optional<PatientAxes> axes, const Frame& world);

}  // namespace certet::command
