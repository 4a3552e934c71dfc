#include "places.hpp"

#include <bit>

#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// How a zero vertex has moved.
const Displacement& move_of(const WarpedLattice& warped, const VertexIndex& v) {
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
  return layer.displacements[rank];
}

}  // namespace

Coord3 place_of(const WarpedLattice& warped, const Lattice& lattice, const PointIndex& point) {
  const auto& [kind, i, j, k] = point;
  const int w = i >> 6;
  const int b = i & 63;
  if (point.is_corner()) {
    const bool moved = (warped.planes.zero(kind, j, k)[w] >> b & 1) != 0;
    return moved_place(lattice, point.vertex(),
                       moved ? move_of(warped, point.vertex()) : Displacement{});
  }
  RowRanks row;
  row.compute(warped.planes, j, k);
  const std::size_t f = point.family();
  const bool from_first = (warped.planes.measured_from_first(f, j, k, w) >> b & 1) != 0;
  return cut_place(lattice, families[f], {i, j, k}, from_first,
                   warped.cuts[k].at(j, row, row.rank(kind, w, b)));
}

}  // namespace certet::core
