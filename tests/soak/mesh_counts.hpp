#pragma once
/// \file
/// What every trial counts of its mesh.

#include <algorithm>
#include <cstdint>

namespace soak {

/// Of a mesh, or of many together.
struct MeshCounts {
  std::uint64_t tets = 0;
  std::uint64_t pairs = 0;  ///< of tetrahedra, looked at for an overlap
  std::int64_t pieces = 0, tunnels = 0, cavities = 0;
  double min_dihedral = 180, max_dihedral = 0;  ///< degrees

  MeshCounts& operator+=(const MeshCounts& other) {
    tets += other.tets;
    pairs += other.pairs;
    pieces += other.pieces;
    tunnels += other.tunnels;
    cavities += other.cavities;
    min_dihedral = std::min(min_dihedral, other.min_dihedral);
    max_dihedral = std::max(max_dihedral, other.max_dihedral);
    return *this;
  }
};

}  // namespace soak
