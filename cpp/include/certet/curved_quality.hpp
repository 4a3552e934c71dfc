#pragma once
/// \file
/// Measuring and verifying tetrahedra of ten nodes, as files hold them.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/mesh.hpp"

namespace certet {

/// What was found of tetrahedra of ten nodes.
struct CurvedQuality {
  std::uint64_t nodes = 0;      ///< in the middle of edges
  std::uint64_t bent = 0;       ///< of these, farther from their middles than rounding explains
  std::uint64_t bad_indices = 0;   ///< middle nodes that are named and not there
  std::uint64_t nonfinite = 0;     ///< middle nodes that are infinite or no numbers
  std::uint64_t torn_edges = 0;    ///< that have several middle nodes
  std::uint64_t shared_nodes = 0;  ///< that are those of several edges
  std::uint64_t nonpositive = 0;   ///< elements whose least bound is not positive
  /// The least Bernstein coefficient of the Jacobian determinant, over that of the element with
  /// straight edges: a lower bound over all elements whose corners are in a positive order.
  double least_jacobian = 1;
  double volume = 0;  ///< of the curved elements; integrated exactly but for rounding
  std::vector<std::string> failures = {};  ///< one sentence for each broken property
};

/// Of each tetrahedron, `middles` are the numbers in `middle_points` of the nodes in the middle of
/// its edges, in the order of `tet_edges`.  Tetrahedra that name a corner that is not there are
/// passed over.
/// \throws Error `cancelled`, `too_large` (out of memory).
CurvedQuality measure_curved(std::span<const Point3> points,
                             std::span<const Tet<std::uint64_t>> tets,
                             std::span<const Point3> middle_points,
                             std::span<const std::array<std::uint64_t, 6>> middles,
                             Context& context);

}  // namespace certet
