#pragma once
/// \file
/// Several solids as one source.

#include "certet/context.hpp"
#include "mesh_options.hpp"
#include "source.hpp"

namespace certet::command {

/// Reads and checks `options.materials`.  \throws Error, `cancelled` too.
Source open_materials(const MeshOptions& options, std::uint64_t max_bytes,
                      const Context& context);

}  // namespace certet::command
