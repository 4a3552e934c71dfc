#pragma once
/// \file
/// Where lines along the axes pass through a solid.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/surface.hpp"
#include "inside.hpp"

namespace certet {

/// How thick the solid is behind a piece of its surface.
struct Thickness {
  double thick = 0;  ///< world units
  double area = 0;   ///< of the piece, in lines
};

/// What lines through the solid find, some twenty thousand along each axis.
struct Chords {
  std::vector<Thickness> behind;  ///< where lines meet the surface
  double inside = 0;  ///< lengths of lines within the solid, each for the area it stands for
  double wound = 0;   ///< the same, each as often as the surface winds around it
};

/// Of an open surface, what is between two of its triangles is inside if its middle is,
/// and nothing else.  \throws Error `cancelled`.
Chords find_chords(const TriangleSurface& surface, Rule rule, const Context& context);

}  // namespace certet
