#pragma once
/// \file
/// The cells that a surface divides space into, where more than two triangles meet.

#include <cstdint>

#include "certet/surface.hpp"

namespace certet {

/// Of a surface in which an odd number of triangles, three or more, meet along edges,
/// or an even number that do not agree: drops what has the same on both its sides,
/// and turns the rest so that it bounds the cells of the solid.  A cell is void if it
/// is the outermost, or if all of its walls face into it as they face out of the
/// solid.  The cells are found by the order of triangles around edges.
/// Returns whether the surface is closed and agrees then; where not, it stays as it was.
bool keep_hull(TriangleSurface& surface, SurfaceRepairs& repairs);

}  // namespace certet
