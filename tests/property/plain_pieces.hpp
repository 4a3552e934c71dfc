#pragma once
/// \file
/// The pieces of a mesh and the faults of its surface, counted plainly: over all
/// tetrahedra, faces, edges and points, knowing nothing of a lattice.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "certet/pieces.hpp"

namespace plain {

using Four = std::array<std::uint64_t, 4>;
using Two = std::array<std::uint64_t, 2>;

struct Mesh {
  std::vector<certet::Point3> points;
  std::vector<Four> tets;
  std::vector<std::int32_t> labels;  ///< of the tetrahedra, or none
};

/// The pieces of a label's tetrahedra, or of all: what is joined by so many common points.
/// Each is a list of numbers of tetrahedra, growing; they are in the order of their first.
std::vector<std::vector<std::size_t>> pieces(const Mesh& mesh, std::size_t points,
                                             std::optional<std::int32_t> label = {});

/// The pairs of tetrahedra that share a face, in growing order.
std::vector<Two> sharing_tets(const Mesh& mesh);

/// Edges in more than two faces of the boundary, and vertices whose faces there do not go
/// once around.
struct Faults {
  std::set<Two> edges;
  std::set<std::uint64_t> vertices;
};
Faults faults(const Mesh& mesh);

/// All of it, as the library tells it.
certet::Pieces count(const Mesh& mesh);

}  // namespace plain
