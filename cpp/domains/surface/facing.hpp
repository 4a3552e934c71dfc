#pragma once
/// \file
/// Pieces of an open surface that touch nowhere, and which way they should face.

#include <cstdint>

#include "certet/context.hpp"
#include "patches.hpp"

namespace certet {

/// Turns pieces of few triangles, which no edge joins to others, so that each closes what
/// the others leave open: their winding number is to fall through it, from back to front.
/// Returns how many triangles were turned.
std::uint64_t face_as_others(TriangleSurface& surface, const SurfacePatches& patches,
                             const Context& context);

/// Which part of the area of such pieces faces the other way; 0 if there are none.
double facing_against(const TriangleSurface& surface, const Context& context);

}  // namespace certet
