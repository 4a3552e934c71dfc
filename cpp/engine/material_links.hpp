#pragma once
/// \file
/// The rule of who moves, where several materials meet: `SettleMaterials` of the certificate.

#include <array>
#include <cstdint>

#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "link.hpp"
#include "vertex_index.hpp"
#include "violations.hpp"

namespace certet::core {

/// What samples of several materials tell of violated vertices.
///
/// A vertex is between two materials, its own and that to which its move leads.  It may
/// move if its link is a strict disk for each of the materials around it but the lowest,
/// that material being plus and all others minus, and for all of these together.  Where
/// there are but two it is the greater one that counts, as in a solid of one material.
/// So each material keeps its pieces, cavities and tunnels.  A tetrahedron all of whose
/// corners move is of the material that is the lower one of each.  Where there is no such
/// material, or a sample beside a corner is of a lower one, so that the tetrahedron might touch
/// others in an edge alone, or where it is not the outside, so that the tetrahedron is kept, and
/// it is not well shaped, the last of the corners stays: `AreDisks`, `FillsWouldTouch` and
/// `MayShare` of the certificate.
class MaterialLinks {
 public:
  /// `samples` has materials, or is of one, and then nothing may be asked.
  MaterialLinks(const SignPlanes& samples, const Violations& violations, const Lattice& lattice)
      : materials_(samples.materials()), violations_(violations), lattice_(lattice) {}

  [[nodiscard]] bool are_asked() const { return materials_ != nullptr; }
  /// Whether a violated vertex is of the greater of its two materials.
  [[nodiscard]] bool is_greater(const VertexIndex& v, const Displacement& move) const;
  /// The lesser of the two materials of a violated vertex.
  [[nodiscard]] Material lower(const VertexIndex& v) const;
  /// Whether the link is as it must be; `zero` are the neighbours that have moved.
  [[nodiscard]] bool are_disks(const VertexIndex& v, const Displacement& move,
                               LinkSet zero) const;
  /// Whether all tetrahedra that would then have four moved corners, v being the last that
  /// moves, are what they must be.
  [[nodiscard]] bool may_share(const VertexIndex& v, const Displacement& move,
                               LinkSet zero) const;

 private:
  /// Whether a violated vertex is between such a material and a higher one, and no sample
  /// around it is of a lower one.
  [[nodiscard]] bool is_lowest(Material shared, const VertexIndex& v) const;
  [[nodiscard]] Material material(const VertexIndex& v) const {
    return materials_->at(v.grid, v.i, v.j, v.k);
  }

  const MaterialPlanes* materials_;
  const Violations& violations_;
  const Lattice& lattice_;
};

}  // namespace certet::core
