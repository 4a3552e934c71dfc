#pragma once
/// \file
/// Vertices that move so that the worst dihedral angles grow.

#include <cstdint>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/mesh.hpp"

namespace certet {

/// No tetrahedron has a worst angle beyond 70.53 degrees, nor the lattice's own one beyond this.
inline constexpr double greatest_goal = 60;

/// How far `optimise` goes.
struct OptimiseGoal {
  /// Vertices move as long as an angle around them is nearer than this to 0° or to 180°, in
  /// degrees.
  double angle = 25;
  int rounds = 8;  ///< over all vertices that such an angle is at, at most, in each of four turns
};

/// How far from where stuffing put it a vertex may come, in long edges; those of a default size
/// are a voxel of an image long.
inline constexpr double interior_reach = 0.5, surface_reach = 0.25, seam_reach = 0.125;

/// Where an angle is still nearer than this to 0° or to 180°, in degrees, and no vertex can help
/// along its surface, one may leave that, or its seam or corner, by so much, in long edges.
inline constexpr double dire_angle = 15, loose_reach = 0.125;

/// What became of a mesh that was optimised.
struct OptimiseFigures {
  double goal = 0;             ///< degrees
  int rounds = 0;
  std::uint64_t moved = 0;     ///< vertices, all of them
  std::uint64_t moved_on_surface = 0;  ///< of those, on the boundary or an interface
  std::uint64_t left_surface = 0;      ///< of those, off it, by `loose_reach` at most
  std::uint64_t moved_on_seams = 0;    ///< of those, where more than two regions meet
  double greatest_move = 0;    ///< in long edges
  double greatest_move_on_surface = 0;
  /// Tetrahedra with an angle nearer than the goal to 0° or to 180°.
  std::uint64_t short_before = 0, short_after = 0;
};

/// Moves vertices of a mesh one after the other, each only where of all angles around it the one
/// that is nearest to 0° or to 180° grows away from that, and no angle around it comes to be less
/// than the least of the mesh was or greater than the greatest; all tetrahedra stay positive.
/// So the bounds of the theorem that covers the mesh hold still.  Gains and signs are decided
/// beyond what doubles round; that no angle leaves what the mesh had, to what they round.
/// Topology, numbers and labels stay.
///
/// Vertices of a surface, of the boundary or between two regions, stay on it: they are put where
/// bisection along the surface's normal finds the domain to change its side, to one step.  Where
/// that finds no surface they stay, but for those that settling had put beside it: these move along
/// the surface that the mesh has, by `seam_reach` at most.  Those at which more than two regions
/// meet move along the line where they do so, as the mesh has it, by `seam_reach` at most, or stay.
/// Vertices of a face where the shape is cut off stay in it, and those of its edges on these.
/// Below `dire_angle` one may leave its surface, as is said there.  Sheets of the boundary that are
/// nearer to each other than their vertices move are not looked at.
///
/// `domain` is what the mesh was made of.  The result does not depend on the number of threads.
/// \throws Error `cancelled`, `too_large` (out of memory), `bad_option` (a goal that is not from
/// 0 to 60 degrees; cuts in the middle of edges, whose surface is none to move on); what the
/// domain throws.
OptimiseFigures optimise(Mesh& mesh, const Domain& domain, const OptimiseGoal& goal,
                         Context& context);
inline OptimiseFigures optimise(Mesh& mesh, const Domain& domain, const OptimiseGoal& goal = {}) {
  Context context;
  return optimise(mesh, domain, goal, context);
}

}  // namespace certet
