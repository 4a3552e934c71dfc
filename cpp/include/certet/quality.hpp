#pragma once
/// \file
/// Measuring tetrahedra: dihedral angles and volume.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "certet/mesh.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// What is measured; results of parts of a mesh can be added up, in any order,
/// to the result of the whole.
struct Quality {
  static constexpr int bins = 36;  ///< of 5 degrees each

  std::uint64_t tets = 0;
  std::uint64_t nonpositive = 0;  ///< tetrahedra with volume <= 0 (or not finite)
  double min_dihedral = 180;      ///< degrees; over the positive tetrahedra
  double max_dihedral = 0;
  std::array<std::uint64_t, bins> histogram{};  ///< of all six angles of each
  double volume = 0;  ///< sum of the volumes, signed

  Quality& operator+=(const Quality& other);
};

/// Measures tetrahedra in world coordinates.  `points` are all points that the
/// tetrahedra name, the first of them having number `first_point`.
Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint32_t>> tets);
Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint64_t>> tets);

/// Measures tetrahedra in lattice coordinates; `volume` is in long edges cubed
/// (a lattice unit is half a long edge), orientation is decided exactly.
Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint32_t>> tets);
Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint64_t>> tets);

/// What a theorem promises of a mesh, in degrees.
struct AngleBounds {
  double min_dihedral, max_dihedral;
  std::string_view theorem;  ///< its name in coq/Certificate.v
};

/// The theorem that covers a mesh made this way.
AngleBounds proven_bounds(Cuts cuts, Guarantee guarantee);

}  // namespace certet
