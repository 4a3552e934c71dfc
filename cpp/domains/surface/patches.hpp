#pragma once
/// \file
/// Pieces of a surface whose triangles agree which side is out.

#include <cstdint>
#include <vector>

#include "certet/surface.hpp"

namespace certet {

/// Triangles that are joined by edges of two triangles.
struct SurfacePatches {
  std::vector<std::uint32_t> of;  ///< each triangle
  std::uint32_t count = 0;
  bool orientable = true;         ///< or one of them has one side only
};

/// Turns triangles, so that those of a patch agree: in each patch those that have
/// the lesser area or, of equal ones, those that leave it inside out.  A surface
/// that is not orientable stays as it is.  Adds to `turned` how many were.
SurfacePatches agreed_patches(TriangleSurface& surface, std::uint64_t& turned);

}  // namespace certet
