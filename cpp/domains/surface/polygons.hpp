#pragma once
/// \file
/// Polygons of files, cut into triangles.

#include <cstdint>
#include <span>

#include "certet/surface.hpp"

namespace certet {

/// Adds the triangles of a polygon whose corners are numbers of points that are
/// there.  Ears are cut off one after the other, so that a polygon may have corners
/// that go inwards; the triangles run around the way it does.  Fewer than three
/// corners make none.
void add_polygon(std::span<const std::uint32_t> corners, TriangleSurface& surface);

}  // namespace certet
