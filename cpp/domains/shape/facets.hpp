#pragma once
/// \file
/// Triangles of solids that have sharp edges.

#include <vector>

#include "certet/placed_domain.hpp"
#include "distances.hpp"

namespace certet::shape {

std::vector<TriangleCorners> facets_of(const Box& box, const Frame& frame);
/// Within a step of it, if ten thousand sides allow that.
std::vector<TriangleCorners> facets_of(const Cylinder& cylinder, const Frame& frame);
/// Others have none.
template <class Solid>
std::vector<TriangleCorners> facets_of(const Solid&, const Frame&) {
  return {};
}

}  // namespace certet::shape
