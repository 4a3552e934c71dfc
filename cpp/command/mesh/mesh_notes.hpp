#pragma once
/// \file
/// What the help of `certet mesh` says beyond its options.

namespace certet::command {

/// Formulas, shapes, images, warnings, files, and the keys of the JSON.
extern const char* const mesh_notes;

}  // namespace certet::command
