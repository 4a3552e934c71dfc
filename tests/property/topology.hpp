#pragma once
/// \file
/// Pieces, tunnels and cavities, counted twice: of samples, and of a mesh.

#include <array>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "settling_model.hpp"

namespace topology {

/// Betti numbers of a solid in space.
struct Shape {
  std::int64_t pieces = 0, tunnels = 0, cavities = 0;
  friend bool operator==(const Shape&, const Shape&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Shape& s) {
    return out << s.pieces << " pieces, " << s.tunnels << " tunnels, " << s.cavities << " cavities";
  }
};

/// Of those lattice points that are +, joined along the edges of the lattice, with its
/// triangles and tetrahedra between them.
Shape of_samples(const std::vector<certet::Coord3>& vertices,
                 const std::function<bool(certet::Coord3)>& is_plus);
Shape of_samples(const settling::Model& model);

/// Of a mesh whose surface is a manifold.
Shape of_mesh(const settling::Tets& mesh);

using Triangle = std::array<std::uint32_t, 3>;

/// Of faces, sorted, each with what belongs to it: those that are there once.
template <class With, class Visit>
void for_each_single(const std::vector<std::pair<Triangle, With>>& faces, const Visit& visit) {
  for (std::size_t n = 0; n < faces.size(); ++n) {
    const bool twice = (n > 0 && faces[n - 1].first == faces[n].first) ||
                       (n + 1 < faces.size() && faces[n + 1].first == faces[n].first);
    if (!twice) visit(faces[n].first, faces[n].second);
  }
}

/// Faces that only one tetrahedron has, their corners by growing numbers.
std::vector<Triangle> surface_of(const settling::Tets& mesh);

/// Pieces of a mesh that hang together by faces.
std::int64_t pieces_by_faces(const settling::Tets& mesh);

/// What keeps the surface of a mesh from being a closed manifold, in words: an edge that is
/// not in two of its triangles, or a vertex with several fans.
std::string surface_fault(const settling::Tets& mesh);

}  // namespace topology
