#pragma once
/// \file
/// Solids from files, formulas and shapes.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/labels.hpp"
#include "certet/patient_axes.hpp"
#include "certet/solid.hpp"
#include "mesh_options.hpp"

namespace certet::command {

/// A solid, and what its file tells.
struct OpenedSolid {
  Solid solid;
  std::vector<std::string> notes = {};  ///< what is doubtful about it, a sentence each
  LabelNames names = {};                ///< of labels that stay apart
  bool has_labels = false;              ///< each is a material
  bool is_image = false;
  std::optional<PatientAxes> axes = {};  ///< of an image's file, where it tells
};

/// Reads and checks a solid.  Labels of an image are one solid, unless they are kept apart; gray
/// is one.  \throws Error, `cancelled` too.
OpenedSolid open_solid(const SolidChoice& choice, bool keeps_labels, const MeshOptions& options,
                       std::uint64_t max_bytes, const Context& context);

/// A solid that is no image where the output is turned over: its coordinates are the output's.
Solid in_axes(const OpenedSolid& opened, std::optional<PatientAxes> output);

}  // namespace certet::command
