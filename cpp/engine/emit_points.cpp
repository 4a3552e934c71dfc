#include <algorithm>

#include "emit.hpp"
#include "emit_loop.hpp"
#include "places.hpp"

namespace certet::core {
namespace {

/// Corners of one grid: where the lattice has them, or where warping moved them.
Coord3* emit_corners(const WarpedLattice& warped, const Lattice& lattice, const RowRanks& row,
                     Grid grid, int j, int k, const Displacement*& displacement, Coord3* out) {
  const SignPlanes& planes = warped.planes;
  for (int w = 0; w < planes.words(); ++w) {
    const std::uint64_t zero = planes.zero(grid, j, k)[w];
    for_each_bit(row.mask(grid, w), [&](int b) {
      const bool moved = (zero >> b & 1) != 0;
      *out++ = moved_place(lattice, {grid, 64 * w + b, j, k},
                           moved ? *displacement++ : Displacement{});
    });
  }
  return out;
}

/// Cuts of one family.
Coord3* emit_cuts(const WarpedLattice& warped, const Lattice& lattice, const RowRanks& row,
                  std::size_t f, int j, int k, const std::uint16_t*& cut, Coord3* out) {
  for (int w = 0; w < row.words(); ++w) {
    const std::uint64_t mask = row.mask(corner_kinds + f, w);
    if (mask == 0) continue;
    const std::uint64_t from_first = warped.planes.measured_from_first(f, j, k, w);
    for_each_bit(mask, [&](int b) {
      const bool forward = (from_first >> b & 1) != 0;
      *out++ = cut_place(lattice, families[f], {64 * w + b, j, k}, forward, *cut++);
    });
  }
  return out;
}

/// The points of row (j,k), in the order of RowRanks, from `out` on.
void emit_row_points(const WarpedLattice& warped, const Lattice& lattice, const RowRanks& row,
                     int j, int k, Coord3* out) {
  const DisplacedLayer& zeros = warped.zeros[k];
  const CutLayer& cuts = warped.cuts[k];
  const Displacement* displacement =
      zeros.displacements.data() + zeros.row_begin[static_cast<std::size_t>(j)];
  const std::uint16_t* cut = cuts.steps.data() + cuts.row_begin[static_cast<std::size_t>(j)];
  for (const Grid grid : grids)
    out = emit_corners(warped, lattice, row, grid, j, k, displacement, out);
  for (std::size_t f = 0; f < family_count; ++f)
    out = emit_cuts(warped, lattice, row, f, j, k, cut, out);
}

/// Tells of the same points whether they lie on the surface.
void mark_row_points(const SignPlanes& planes, const RowRanks& row, int j, int k,
                     std::uint8_t* out) {
  std::uint8_t* const cuts = out + row.corners();
  for (const Grid grid : grids)
    for (int w = 0; w < planes.words(); ++w) {
      const std::uint64_t zero = planes.zero(grid, j, k)[w];
      for_each_bit(row.mask(grid, w),
                   [&](int b) { *out++ = static_cast<std::uint8_t>(zero >> b & 1); });
    }
  std::fill(cuts, cuts + (row.count() - row.corners()), std::uint8_t{1});
}

/// Calls emit(row, j, k, to) for every row of a window, `to` being where its
/// points go in `out`.
template <class T, class Emit>
void for_each_row(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
                  Window window, std::span<T> out, Context& context, const Emit& emit) {
  const std::uint64_t start = numbers.first_point(0, window.begin);
  check_room(out.size(), numbers.first_point(0, window.end) - start);
  for_each_piece(lattice, window, context, [&](int j_begin, int j_end, int k) {
    RowRanks row;
    for (int j = j_begin; j < j_end; ++j) {
      row.compute(warped.planes, j, k, numbers.graded());
      emit(row, j, k, out.data() + (numbers.first_point(j, k) - start));
    }
  });
}

}  // namespace

void emit_points(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
                 Window window, std::span<Coord3> out, Context& context) {
  for_each_row(warped, numbers, lattice, window, out, context,
               [&](const RowRanks& row, int j, int k, Coord3* to) {
                 emit_row_points(warped, lattice, row, j, k, to);
               });
}

void mark_surface(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
                  Window window, std::span<std::uint8_t> out, Context& context) {
  for_each_row(warped, numbers, lattice, window, out, context,
               [&](const RowRanks& row, int j, int k, std::uint8_t* to) {
                 mark_row_points(warped.planes, row, j, k, to);
               });
}

}  // namespace certet::core
