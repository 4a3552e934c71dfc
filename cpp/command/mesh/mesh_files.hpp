#pragma once
/// \file
/// The files of a run: what is read, and what may be written.

#include "mesh_options.hpp"

namespace certet::command {

/// Refuses outputs that cannot be written, or that the run reads or writes otherwise.
/// \throws Error `bad_option`, `write_failed`.
void check_outputs(const MeshOptions& options);

}  // namespace certet::command
