#pragma once
/// \file
/// Measuring tetrahedra: dihedral angles and volume.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "certet/mesh.hpp"
#include "certet/method.hpp"

namespace certet {

/// A sum of 64-bit integers that cannot overflow, and that therefore does not
/// depend on the order of its terms: a two's complement number of 128 bits.
struct WideSum {
  std::uint64_t low = 0;
  std::int64_t high = 0;

  WideSum& operator+=(std::int64_t term);
  WideSum& operator+=(const WideSum& other);
  /// `factor` added so many times.
  static WideSum product(std::int64_t factor, std::uint64_t times);
  [[nodiscard]] double value() const;  ///< within one unit of the last place
  friend bool operator==(const WideSum&, const WideSum&) = default;
};

/// What is measured; results of parts of a mesh can be added up, in any order,
/// to the result of the whole.
///
/// Everything is independent of the parts and of their order, down to the last
/// bit, but for the volume in world coordinates: it is summed in floating point
/// in the order of the tetrahedra, and of the additions, so that parts that are
/// the same and are added in the same order give the same bits.
struct Quality {
  static constexpr int bins = 36;  ///< of 5 degrees each: [0,5), [5,10), …

  std::uint64_t tets = 0;
  std::uint64_t nonpositive = 0;  ///< tetrahedra with volume <= 0 (or not finite)
  double min_dihedral = 180;      ///< degrees; over the positive tetrahedra
  double max_dihedral = 0;
  std::array<std::uint64_t, bins> histogram{};  ///< of all six angles of each
  double volume = 0;  ///< sum of the volumes, signed; without those that are not finite

  /// cot |cot| of the two extreme angles, which are these, in degrees.
  double sharpest = -std::numeric_limits<double>::infinity();
  double bluntest = std::numeric_limits<double>::infinity();
  /// The square of twice the least area of a face, in the units measured; over the
  /// tetrahedra whose faces are neither so small nor so large that it leaves the range.
  double least_face = std::numeric_limits<double>::infinity();
  /// Six times the volume in steps cubed, where lattice coordinates were
  /// measured; then `volume` is this, in other units.
  WideSum steps_volume;

  Quality& operator+=(const Quality& other);
};

/// Whether `Quality::histogram` is made or stays empty.
enum class Histogram { counted, empty };

/// Measures tetrahedra in world coordinates.  `points` are all points that the
/// tetrahedra name, the first of them having number `first_point`.  Every
/// tetrahedron is computed from its own four rounded points.
Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint32_t>> tets,
                      Histogram histogram = Histogram::counted);
Quality measure_world(std::span<const Point3> points, std::uint64_t first_point,
                      std::span<const Tet<std::uint64_t>> tets,
                      Histogram histogram = Histogram::counted);

/// Measures tetrahedra in lattice coordinates; `volume` is in long edges cubed
/// (a lattice unit is half a long edge), orientation is decided exactly.  Every
/// tetrahedron is looked at; those whose edges are the same integer vectors have
/// the same angles and volume, which are computed once.
/// \throws Error `bad_input` if a tetrahedron is wider than 2^20 steps (16 lattice
/// units) along an axis, or beyond `coordinate_limit`; those that stuffing makes are
/// at most a quarter as wide, and those of graded meshes no wider.
Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint32_t>> tets);
Quality measure_lattice(std::span<const Coord3> points, std::uint64_t first_point,
                        std::span<const Tet<std::uint64_t>> tets);

/// Whether all tetrahedra are positive and all angles within the bounds, but for
/// `rounding` degrees.
bool within(const Quality& quality, const AngleBounds& bounds, double rounding);

/// Angles are shown in thousandths of a degree, and those of world coordinates are
/// checked as they are shown: rounding has its part in them, and a theorem whose
/// bounds are attained leaves it no room.
inline constexpr double shown_rounding = 0.0005;

/// What is wrong with the angles of a mesh in world coordinates, checked as they are
/// shown, in one sentence; empty where nothing is.  `whose` says where the bounds
/// come from.  Tetrahedra that are not positive have no angles.
std::string angle_defect(const Quality& world, const AngleBounds& bounds,
                         std::string_view whose);

}  // namespace certet
