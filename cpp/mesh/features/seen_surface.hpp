#pragma once
/// \file
/// The boundary of a mesh, and which way the surface of its domain faces at its vertices.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/mesh.hpp"
#include "facing.hpp"

namespace certet::features {

/// Vertices have numbers of their own here.
struct SeenSurface {
  std::vector<std::uint64_t> numbers;   ///< in the mesh, growing
  std::vector<Vector> places;
  std::vector<Vector> normals;          ///< as seen, or those of the triangles around
  std::vector<std::uint8_t> doubtful;   ///< near what may be sharp; elsewhere nothing was looked at
  std::vector<std::uint8_t> known;      ///< of doubtful ones: the surface was seen there
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< anticlockwise from outside

  [[nodiscard]] std::uint32_t number_of(std::uint64_t in_mesh) const;
};

/// Looks where the triangles turn by more than a quarter of an angle, in degrees, and next to it.
SeenSurface see_surface(const Mesh& mesh, const Domain& domain, double angle, Context& context);

}  // namespace certet::features
