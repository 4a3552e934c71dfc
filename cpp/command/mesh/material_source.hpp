#pragma once
/// \file
/// Several solids as one source.

#include "certet/context.hpp"
#include "mesh_options.hpp"
#include "source.hpp"

namespace certet::command {

/// Reads and checks `options.materials`.  \throws Error, `cancelled` too.
Source open_materials(const MeshOptions& options, const Context& context);

}  // namespace certet::command
