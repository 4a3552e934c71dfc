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

/// Such pieces after that.
struct Facing {
  double area = 0;     ///< of them, as a part of the surface's
  double against = 0;  ///< the part of theirs that faces the other way
};
Facing facing_of(const TriangleSurface& surface, const Context& context);

}  // namespace certet
