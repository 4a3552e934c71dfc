#pragma once
/// \file
/// Second stage: signs → cuts.

#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "certet/method.hpp"
#include "row_ranks.hpp"
#include "window.hpp"

namespace certet::core {

/// The cut in the middle of an edge: `MidpointCut` of the certificate.
inline constexpr std::int32_t midpoint_cut = steps / 2;

/// The cuts of one layer of edges, in steps from the + end, row by row in the
/// order of RowRanks.
struct CutLayer {
  std::vector<std::uint16_t> steps;
  /// Where each row starts in `steps`.  A layer of the largest lattice has a
  /// billion indices with 14 edges each: more than 32 bits can count.
  std::vector<std::uint64_t> row_begin;

  /// The cut with the given rank in row j.
  [[nodiscard]] std::int32_t at(int j, const RowRanks& row, std::uint32_t rank) const {
    return steps[row_begin[static_cast<std::size_t>(j)] + rank - row.corners()];
  }
};

/// Where every cut edge of a window is cut: `BisectedCuts` or `MidpointCuts` of the
/// certificate, which lie on their edges whatever the domain answers.  `planes` have
/// one layer more, unless the lattice ends there.
Layers<CutLayer> find_cuts(const SignPlanes& planes, const Domain& domain, const Lattice& lattice,
                           Window window, Cuts cuts, Context& context);

/// The vertex of an index, in lattice units.
constexpr Coord3 lattice_point(const Lattice& lattice, VertexRef ref, int i, int j, int k) {
  return lattice.origin + 2 * Coord3{i + ref.shift.x, j + ref.shift.y, k + ref.shift.z} +
         tiling.grids[ref.grid];
}

}  // namespace certet::core
