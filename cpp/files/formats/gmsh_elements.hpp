#pragma once
/// \file
/// Gmsh's numbers of the types of elements that meshes here are made of.

#include <cstdint>

namespace certet::formats {

inline constexpr std::int32_t gmsh_triangle = 2, gmsh_tetrahedron = 4;
/// Of six and of ten nodes.
inline constexpr std::int32_t gmsh_triangle_6 = 9, gmsh_tetrahedron_10 = 11;

}  // namespace certet::formats
