#pragma once
/// \file
/// The tetrahedra of a mesh of several materials around one of its points, where nothing
/// simpler tells what its boundary is like there.

#include <array>
#include <cstdint>
#include <vector>

#include "material_links.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// A point of the mesh: a vertex twice, or the two ends of its edge, the lesser first.
using MeshNode = std::array<std::uint64_t, 2>;

/// A vertex as a number, in the order in which the mesh's corners are numbered.
constexpr std::uint64_t number_of(const VertexIndex& v) {
  return static_cast<std::uint64_t>(v.k + 1) << 43 | static_cast<std::uint64_t>(v.j + 1) << 22 |
         static_cast<std::uint64_t>(v.grid) << 21 | static_cast<std::uint64_t>(v.i + 1);
}
constexpr VertexIndex vertex_of(std::uint64_t number) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
  return {static_cast<Grid>(number >> 21 & 1), static_cast<std::int32_t>(number & mask) - 1,
          static_cast<std::int32_t>(number >> 22 & mask) - 1,
          static_cast<std::int32_t>(number >> 43) - 1};
}

/// The boundary around a point.
struct BoundaryAround {
  bool one_fan = true;  ///< one closed fan of faces, or none
  /// The other ends of edges that more than two faces of the boundary have.
  std::vector<MeshNode> overfull;
};

/// `planes` are those of the warped lattice, with materials.
BoundaryAround boundary_around(const SignPlanes& planes, const MeshNode& node);

}  // namespace certet::core
