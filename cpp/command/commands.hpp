#pragma once
/// \file
/// The subcommands.

#include "options.hpp"
#include "status.hpp"

namespace certet::command {

/// From an image or a formula to a mesh file.  \throws Error.
Status mesh(const MeshOptions& options);

/// Reads a mesh file and verifies it anew.  \throws Error.
Status check(const CheckOptions& options);

}  // namespace certet::command
