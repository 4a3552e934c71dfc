#pragma once
/// \file
/// What the points of a lattice are made of, and what that says of any mesh of them.

#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "property/exact.hpp"
#include "topology.hpp"

namespace labelled {

using certet::Coord3;
using certet::Material;

/// A set of materials, a bit for each; the outside is bit 0.
using MaterialSet = std::uint32_t;

/// No less and no more, six times as much as the volume is, in steps cubed.
struct VolumeBounds {
  exact::Wide least = 0, most = 0;
};

class Samples {
 public:
  Samples(const certet::Domain& domain, const certet::Lattice& lattice);

  [[nodiscard]] const std::vector<Coord3>& vertices() const { return vertices_; }
  /// Outside where the lattice ends.
  [[nodiscard]] Material at(Coord3 vertex) const;
  /// Of a vertex and its neighbours.
  [[nodiscard]] MaterialSet around(Coord3 vertex) const;

  /// Of all that is of one of these materials.
  [[nodiscard]] topology::Shape shape(MaterialSet materials) const;
  /// Whether a position, in steps, is the cut of a long edge between two other materials
  /// around which this one is at opposite places alone, or all around: there it may touch
  /// itself in a point.
  [[nodiscard]] bool may_touch_itself(Material material, Coord3 position) const;
  /// A vertex moves within its own tetrahedra.  So those of which the corners and all their
  /// neighbours are of these materials are part of the mesh, and those of which none is are
  /// none.
  [[nodiscard]] VolumeBounds volume(MaterialSet materials) const;

 private:
  [[nodiscard]] bool holds(Coord3 vertex) const;
  [[nodiscard]] std::size_t number(Coord3 vertex) const;

  certet::Lattice lattice_;
  std::vector<Coord3> vertices_;
  std::vector<Material> materials_;
  std::vector<MaterialSet> around_;
};

}  // namespace labelled
