#pragma once
/// \file
/// The faces of all tetrahedra, in the order of OpenFOAM: those between two cells first, by the
/// lesser of these, their owner, and then by the greater.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/mesh.hpp"

namespace certet::formats {

/// The faces that one tetrahedron owns, towards those of greater numbers.
struct OwnedFace {
  std::uint32_t neighbour;
  std::uint8_t opposite;  ///< the owner's corner that the face does not have
};

class CellFaces {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Of tetrahedra that all name four different points below `points`.
  CellFaces(std::uint64_t points, const std::vector<Tet<std::uint32_t>>& tets);

  /// Whether each face is in two tetrahedra at most.  Else nothing of all this makes sense.
  [[nodiscard]] bool are_cells() const { return are_cells_; }

  /// How many faces are between two tetrahedra.
  [[nodiscard]] std::uint64_t inner() const { return first_.back(); }

  /// Calls visit(face, place) for the faces that a tetrahedron owns, in their order.
  template <class Visit>
  void for_each_owned(std::uint32_t tet, const Visit& visit) const {
    std::array<OwnedFace, 4> faces;
    const std::size_t count = owned(tet, faces);
    for (std::size_t i = 0; i < count; ++i) visit(faces[i], first_[tet] + i);
  }

  /// Where a face between two tetrahedra is among all faces; `is_owner` tells whether `tet` owns it.
  [[nodiscard]] std::uint64_t place_of(std::uint32_t tet, std::uint8_t opposite,
                                       bool& is_owner) const;

 private:
  std::size_t owned(std::uint32_t tet, std::array<OwnedFace, 4>& faces) const;

  bool are_cells_ = true;
  std::vector<std::array<std::uint32_t, 4>> neighbours_;  ///< opposite to each corner
  std::vector<std::uint64_t> first_;  ///< of the faces that each tetrahedron owns, and the end
};

}  // namespace certet::formats
