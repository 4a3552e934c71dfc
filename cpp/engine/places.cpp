#include "places.hpp"

#include <bit>

#include "row_ranks.hpp"

namespace certet::core {

Coord3 moved_place(const WarpedLattice& warped, const Lattice& lattice, const VertexIndex& v) {
  const DisplacedLayer& layer = warped.zeros[v.k];
  std::uint32_t rank = layer.row_begin[static_cast<std::size_t>(v.j)];
  const auto zeros_before = [&](Grid grid, int end) {
    const std::uint64_t* const zero = warped.planes.zero(grid, v.j, v.k);
    for (int w = 0; 64 * w < end; ++w) {
      const std::uint64_t mask = end - 64 * w >= 64 ? ~std::uint64_t{0} : below(end - 64 * w);
      rank += static_cast<std::uint32_t>(std::popcount(zero[w] & mask));
    }
  };
  for (const Grid grid : grids)
    if (grid < v.grid) zeros_before(grid, 64 * warped.planes.words());
  zeros_before(v.grid, v.i);
  const Displacement& moved = layer.displacements[rank];
  return steps * lattice_point(lattice, {v.grid, {}}, v.i, v.j, v.k) +
         std::int32_t{moved.distance} * tiling.directions[moved.direction];
}

CutEdge edge_from(const VertexIndex& v, std::size_t direction) {
  const EdgeRef& edge = edges_of[v.grid][direction];
  const std::size_t family = edge.kind - std::size_t{corner_kinds};
  return {{families[family].first.grid, v.i + edge.owner.x, v.j + edge.owner.y,
           v.k + edge.owner.z},
          family};
}

Coord3 cut_place(const WarpedLattice& warped, const Lattice& lattice, const CutEdge& edge) {
  const auto& [grid, i, j, k] = edge.owner;
  const int w = i >> 6;
  RowRanks row;
  row.compute(warped.planes, j, k);
  const std::size_t kind = corner_kinds + edge.family;
  const std::int32_t cut = warped.cuts[k].at(j, row, row.rank(kind, w, i & 63));
  const bool forward =
      (warped.planes.measured_from_first(edge.family, j, k, w) >> (i & 63) & 1) != 0;
  const Coord3 first = lattice_point(lattice, families[edge.family].first, i, j, k);
  const Coord3 second = lattice_point(lattice, families[edge.family].second, i, j, k);
  const Coord3 from = forward ? first : second;
  const Coord3 to = forward ? second : first;
  return steps * from + cut * (to - from);
}

}  // namespace certet::core
