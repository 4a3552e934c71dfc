#pragma once
/// \file
/// The mesh that the parts are measured on: a torus of about a million tetrahedra.

#include <span>
#include <variant>
#include <vector>

#include "../torus.hpp"
#include "certet/stuffing.hpp"

namespace certet::bench {

inline constexpr double part_tets = 1e6;

inline const Torus& part_torus() {
  static const Torus torus(size_for(part_tets));
  return torus;
}

inline const Mesh& part_mesh() {
  static const Mesh mesh = [] {
    Context context;
    context.threads = 1;
    return stuff(part_torus(), part_torus().lattice(), {}, {}, context);
  }();
  return mesh;
}

inline std::span<const Tet<std::uint32_t>> part_mesh_tets() {
  return std::get<Buffer<Tet<std::uint32_t>>>(part_mesh().tets);
}

/// The points of the mesh in world coordinates.
inline const std::vector<Point3>& part_mesh_world() {
  static const std::vector<Point3> world = [] {
    std::vector<Point3> points;
    points.reserve(part_mesh().points.size());
    for (const Coord3 p : part_mesh().points) points.push_back(part_mesh().frame.world(p));
    return points;
  }();
  return world;
}

}  // namespace certet::bench
