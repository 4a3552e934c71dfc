#pragma once
/// \file
/// What joins the mesh's parts beside the edges of the lattice, layer by layer.
///
/// Parts are the runs of plus vertices and, numbered behind them, the tetrahedra of four
/// zero vertices.

#include <array>
#include <cstdint>
#include <vector>

#include "plus_runs.hpp"
#include "zero_tets.hpp"

namespace certet::core {

/// Two parts, by their numbers.
using PartPair = std::array<std::uint32_t, 2>;

/// What is found in a layer.
struct LayerJoins {
  std::vector<PartPair> by_faces, by_vertices;  ///< joined so
  /// Around which the surface is not one fan, and of more than two of its faces, the lesser
  /// end first; some more than once.
  std::vector<PointIndex> vertices;
  std::vector<std::array<PointIndex, 2>> edges;

  /// An edge that is found at both of its ends, or at the only zero one.
  void add_edge(const PointIndex& at, const PointIndex& other) {
    if (at < other) edges.push_back({at, other});
    else if (!other.is_corner()) edges.push_back({other, at});
  }
};

/// Adds what zero vertices of layer k join, and how the surface is there.
void add_zero_vertices(const PlusRuns& runs, const ZeroTets& zero_tets, std::int32_t k,
                       LayerJoins& found);

/// The same of the cut long edges, where several materials meet.
void add_long_cuts(const PlusRuns& runs, std::int32_t k, LayerJoins& found);

}  // namespace certet::core
