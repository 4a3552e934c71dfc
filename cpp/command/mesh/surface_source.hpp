#pragma once
/// \file
/// Surfaces from files, checked before they are meshed.

#include <filesystem>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/surface.hpp"

namespace certet::command {

/// A surface, and what the user should know of it, a sentence each.
struct CheckedSurface {
  TriangleSurface surface;
  bool open = false;      ///< its holes are to be closed by the winding number
  std::vector<std::string> notes;
  SurfaceDefects defects;  ///< that are left
  SurfaceMeasures measures;
  SurfaceSize size;       ///< if none is asked for
  std::string size_note;  ///< why it is less than usual, if it is
};

/// Reads a surface and mends what exporters do to it; closes its holes only if that is
/// asked for.  \throws Error `bad_input`, for an open one too; `cancelled`.
CheckedSurface open_surface(const std::filesystem::path& file, bool close_holes,
                           const Context& context);

}  // namespace certet::command
