#pragma once
/// \file
/// Middle nodes that lie on the surface.

#include <cstdint>

#include "certet/domain.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/survey.hpp"

namespace certet {

/// No element's Jacobian determinant falls below this part of what it is while its edges are
/// straight; decided by its Bernstein coefficients, in whole numbers.
inline constexpr int least_jacobian_divisor = 4;

/// What became of the edges of the boundary and of the interfaces.
struct CurveFigures {
  std::uint64_t edges = 0;     ///< all of them, but for those where the shape is cut off
  std::uint64_t moved = 0;     ///< the middle node was put on the surface
  std::uint64_t on_surface = 0;  ///< it was there
  std::uint64_t guarded = 0;   ///< it stayed, or else an element would be spoilt
  std::uint64_t far = 0;       ///< it stayed: no surface within a quarter of the edge
  std::uint64_t seams = 0;     ///< it stayed, where more than two regions meet or on a rim
  double greatest_move = 0;    ///< in long edges
  /// A lower bound on the Jacobian determinant of all elements, as a part of that of the
  /// straight element; attained at a corner or not.
  double least_jacobian = 1;
};

/// Puts the middle nodes of boundary and interface edges on the surface: along the mean normal of
/// the triangles around the edge, in steps, where bisection finds the domain to change its side
/// within a quarter of the edge.  Edges of which an element would be spoilt stay straight: of each
/// such element the one that is bent most, and so on until there are none.  `found` is the survey
/// of the mesh, and `domain` what the mesh was made of.  The result does not depend on the
/// number of threads.
/// \throws Error `cancelled`, `too_large` (out of memory), `bad_option` (cuts in the middle of
/// edges, whose surface is none to be put on); what the domain throws.
CurveFigures curve(MiddleNodes& middles, const Mesh& mesh, const Survey& found,
                   const Domain& domain, Context& context);
/// The same, of a mesh that is surveyed for it.
inline CurveFigures curve(MiddleNodes& middles, const Mesh& mesh, const Domain& domain) {
  Context context;
  return curve(middles, mesh, survey(mesh, context), domain, context);
}
/// The same of a mesh that is counted but not written; holds the elements at its surface.
CurveFigures curve(MiddleNodes& middles, const Stuffing& stuffing, const Survey& found,
                   const Domain& domain, Context& context);

}  // namespace certet
