#include "certet/placed_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace certet {
namespace {

constexpr double half_turn = 180;  // degrees

/// What measuring in lattice coordinates may be wrong by, in degrees.  Normals are
/// exact there, so that a cosine comes within 8 units of 2^-53, and an angle from 9 to
/// 165 degrees within 1e-12.
constexpr double lattice_error = 1e-9;

/// Long edges; an edge of the lattice is one, and warping moves each of its ends by
/// less than half of one.
constexpr double longest_edge = 2;

double degrees_of_sine(double sine) {
  return std::asin(std::min(sine, 1.0)) * (half_turn / std::numbers::pi);
}

/// In lattice units, for positions in steps.
std::int32_t reach_of(std::span<const Coord3> points) {
  std::int32_t greatest = 0;
  for (const Coord3 p : points)
    greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return greatest / steps + 1;
}

/// Whether rounding alone can have made of the lattice's angles what the world has.
bool excused(const PlacedQuality& placed, const AngleBounds& bounds) {
  const double rounding = placed.rounding + lattice_error;
  // A tetrahedron becomes flat where an angle can become 0.
  const bool can_be_flat = !(rounding < bounds.min_dihedral);
  return can_be_flat || within(placed.world, bounds, rounding);
}

}  // namespace

AngleBounds bounds_of(const Mesh& mesh) {
  const auto& labels = mesh.labels;
  const bool several =
      std::ranges::adjacent_find(labels, std::ranges::not_equal_to()) != labels.end();
  return bounds_of(mesh.method, several && facts(mesh.method).interfaces);
}

Standing standing_of(const PlacedQuality& placed, const AngleBounds& bounds) {
  if (placed.lattice.tets != placed.world.tets ||
      !within(placed.lattice, bounds, lattice_error))
    return Standing::outside;
  if (within(placed.world, bounds, shown_rounding))
    return placed.coincident_points == 0 ? Standing::within : Standing::blurred;
  return excused(placed, bounds) ? Standing::blurred : Standing::outside;
}

double angle_rounding(const Frame& frame, std::int32_t reach, const Quality& lattice) {
  const double twice_area = std::ldexp(std::sqrt(lattice.least_face), -2 * (step_bits + 1));
  const double moved = std::numbers::sqrt3 * frame.rounding(reach);
  // The normal of a face is a product of two edges whose ends have moved; how far it
  // moved itself, over its length, is the sine of what it turned by.
  const double normal_moved = 4 * longest_edge * moved + 4 * moved * moved;
  // A linear map whose greatest and least stretch have the ratio k turns an angle by
  // the arc sine of (k² - 1) / (k² + 1) at most.
  const double sheared = 3 * frame.skew();
  const double turn = 2 * degrees_of_sine(normal_moved / twice_area) + degrees_of_sine(sheared);
  return turn < half_turn ? turn : half_turn;
}

bool rounding_matters(const Frame& frame, std::int32_t reach) {
  return !frame.is_rotation(1e-12) || !(frame.rounding(reach) <= 1e-11);
}

Quality similar(Quality lattice, const Frame& frame) {
  lattice.volume *= frame.size * frame.size * frame.size;
  lattice.histogram.fill(0);
  return lattice;
}

PlacedQuality measure_placed(const Mesh& mesh, std::span<const Point3> world) {
  const std::int32_t reach = reach_of(mesh.points);
  PlacedQuality placed;
  std::visit(
      [&](const auto& tets) {
        using Index = std::remove_cvref_t<decltype(tets[0][0])>;
        const std::span<const Tet<Index>> all = tets;
        placed.lattice = measure_lattice(mesh.points, 0, all);
        placed.world = measure_world(world, 0, all, Histogram::empty);
      },
      mesh.tets);
  placed.rounding = angle_rounding(mesh.frame, reach, placed.lattice);
  placed.coincident_points = count_coincident(world);
  return placed;
}

PlacedQuality quality(const Mesh& mesh) { return measure_placed(mesh, world_points(mesh)); }

}  // namespace certet
