#pragma once
/// \file
/// What a mesh must be once vertices have moved onto features, found out without the library's
/// own trees, chains and guard.

#include <functional>
#include <string>

#include "certet/features.hpp"

namespace judge {

/// What is wrong, in words; empty if nothing is.  Numbers and labels are as they were, all
/// tetrahedra positive and within the bounds of the method, and all vertices that moved and are
/// on the boundary lie on the triangles of the surface, to two steps.
std::string fault(const certet::Mesh& before, const certet::Mesh& after,
                  const certet::Features& features);

/// The same of a solid that a function tells, as its distance or about that, in world units; negative
/// inside.  Vertices lie on its surface to `steps`.
std::string fault(const certet::Mesh& before, const certet::Mesh& after,
                  const std::function<double(certet::Point3)>& distance, double steps = 24);

/// How far the sharp edges are from the edges of the boundary, in long edges.
struct Nearness {
  double greatest = 0;
  double share = 0;         ///< of their length within 2 % of a long edge
  std::size_t corners = 0;  ///< with a vertex of the boundary exactly there
};
Nearness nearness(const certet::Mesh& mesh, const certet::Features& features);

/// In world units cubed.
double volume(const certet::Mesh& mesh);

}  // namespace judge
