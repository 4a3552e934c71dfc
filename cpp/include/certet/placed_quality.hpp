#pragma once
/// \file
/// What becomes of a mesh's angles on the way from the lattice to the world.

#include <cstdint>
#include <span>

#include "certet/frame.hpp"
#include "certet/mesh.hpp"
#include "certet/quality.hpp"

namespace certet {

/// A mesh, measured before and after its coordinates were rounded.
struct PlacedQuality {
  Quality lattice;  ///< in exact lattice coordinates
  /// In world coordinates; without histogram.  That of the lattice where rounding
  /// cannot turn an angle by 1e-6 degrees, and measured elsewhere.
  Quality world;
  double rounding = 0;  ///< degrees by which rounding can turn an angle; see `angle_rounding`
  std::uint64_t coincident_points = 0;  ///< at the very place of another, by rounding
};

/// How a mesh stands to the bounds of its theorem.
enum class Standing {
  within,   ///< within them, in the lattice and, as angles are shown, in the world
  blurred,  ///< within them in the lattice, but the doubles of the world are too far
            ///< apart there: angles, orientations or distinct points were lost
  outside,  ///< outside of them, and rounding is no excuse
};

/// The theorem speaks of the lattice, which is checked but for the errors of measuring;
/// the world is checked as `shown_rounding` says.
Standing standing_of(const PlacedQuality& placed, const AngleBounds& bounds);

/// A bound, in degrees, on how far rounding to the world's doubles can turn a dihedral
/// angle of a mesh that stuffing made: from how far apart doubles are at its origin,
/// from how far the frame is from a similarity, and from the least face there is.
/// `reach` is the greatest magnitude of a coordinate, in lattice units, and `lattice`
/// was measured in lattice coordinates.
double angle_rounding(const Frame& frame, std::int32_t reach, const Quality& lattice);

/// Whether rounding could turn an angle by 1e-6 degrees, so that the world has to be
/// measured too.  Points moved by 1e-11 long edges turn a face by less than that as
/// long as its altitudes are above a 250th of a long edge; the least that random sign
/// fields lead to is an eighth.
bool rounding_matters(const Frame& frame, std::int32_t reach);

/// The lattice's quality in the world, where rounding does not matter: a similarity
/// transform changes nothing but the volume.
Quality similar(Quality lattice, const Frame& frame);

/// How many points are at the very place of an earlier one.  Those that are not finite
/// are left out.
std::uint64_t count_coincident(std::span<const Point3> points);

/// Measures a whole mesh.  `world` are its points in the world.
PlacedQuality measure_placed(const Mesh& mesh, std::span<const Point3> world);

/// The theorem that covers a mesh: that on several materials where its labels are cut apart.
AngleBounds bounds_of(const Mesh& mesh);

/// The dihedral angles (degrees) and the volume of a mesh, in exact coordinates and in
/// world units; `standing_of` compares them with `bounds_of(mesh)`.
/// \throws Error `too_large` (out of memory).
PlacedQuality quality(const Mesh& mesh);

}  // namespace certet
