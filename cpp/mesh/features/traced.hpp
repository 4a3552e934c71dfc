#pragma once
/// \file
/// The sharp edges of a solid of which signs alone are known, found from a mesh of it.

#include <cstdint>
#include <vector>

#include "certet/features.hpp"
#include "seen_surface.hpp"

namespace certet::features {

/// A part of a sharp edge, as the border of a patch.
struct PatchBorder {
  std::uint32_t patch;
  Vector from, to;
  Vector into;  ///< into the patch, of length 1
};

struct Traced {
  Features features;                   ///< without triangles
  SeenSurface surface;
  std::vector<std::uint32_t> patches;  ///< of the surface's vertices
  std::vector<PatchBorder> borders;
};

/// Of a domain that `mesh` was made of; sharper than an angle, in degrees.
Traced trace(const Mesh& mesh, const PlacedDomain& domain, double angle, Context& context);

}  // namespace certet::features
