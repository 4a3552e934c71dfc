#include "keep.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "layer_loop.hpp"
#include "piece_count.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// Calls visit(run, mask) for the runs of the cursor's next word.
template <class Visit>
void for_runs_of_word(RunCursor& cursor, int w, const Visit& visit) {
  std::uint64_t plus = cursor.next(w);
  while (plus != 0) {
    const int b = std::countr_zero(plus);
    const int end = b + std::countr_one(plus >> b);
    const std::uint64_t mask = end == 64 ? plus : plus & below(end);
    visit(cursor.run(b), mask);
    plus &= ~mask;
  }
}

/// How far a piece's plus vertices reach along an axis, in lattice units.
struct Reach {
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();

  void add(std::int32_t at) {
    low = std::min(low, at);
    high = std::max(high, at);
  }
};

std::vector<Reach> reaches(const PlusRuns& runs, const NumberedSets& pieces, std::size_t axis) {
  const SignPlanes& planes = runs.planes();
  std::vector<Reach> reach(pieces.count);
  for (int k = 0; k < planes.cells()[2]; ++k)
    for (int j = 0; j < planes.cells()[1]; ++j)
      for (const Grid grid : grids) {
        RunCursor cursor(planes.plus(grid, j, k), 0, runs.first(grid, j, k));
        for (int w = 0; w < planes.words(); ++w)
          for_runs_of_word(cursor, w, [&](std::uint32_t run, std::uint64_t mask) {
            for (const int b : {std::countr_zero(mask), static_cast<int>(std::bit_width(mask)) - 1}) {
              const Coord3 at = 2 * Coord3{64 * w + b, j, k} + tiling.grids[grid];
              reach[pieces.of[run]].add(std::array{at.x, at.y, at.z}[axis]);
            }
          });
      }
  return reach;
}

/// Of each piece, whether it stays.
std::vector<bool> choose(const KeepLargest& rule, const PlusRuns& runs,
                         const NumberedSets& pieces, Context& context) {
  const std::vector<std::uint64_t> tets =
      count_tets_of_pieces(runs, pieces.of, pieces.count, context);
  std::vector<std::uint32_t> order(pieces.count);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](std::uint32_t piece) { return tets[piece]; });
  std::vector<bool> stays(pieces.count, false);
  for (std::size_t n = 0; n < std::min<std::uint64_t>(rule.count, order.size()); ++n)
    stays[order[n]] = true;
  return stays;
}

std::vector<bool> choose(const KeepPercolating& rule, const PlusRuns& runs,
                         const NumberedSets& pieces, Context&) {
  constexpr std::int32_t tolerance = 2;  // a long edge
  const std::vector<Reach> reach = reaches(runs, pieces, rule.axis);
  Reach all;
  for (const Reach& piece : reach) {
    all.add(piece.low);
    all.add(piece.high);
  }
  std::vector<bool> stays;
  stays.reserve(reach.size());
  for (const Reach& piece : reach)
    stays.push_back(piece.low <= all.low + tolerance && piece.high >= all.high - tolerance);
  return stays;
}

/// Turns the plus vertices of a layer that do not stay to minus.
void drop_runs(SignPlanes& planes, const PlusRuns& runs, const std::vector<bool>& stays, int k) {
  for (int j = 0; j < planes.cells()[1]; ++j)
    for (const Grid grid : grids) {
      RunCursor cursor(runs.planes().plus(grid, j, k), 0, runs.first(grid, j, k));
      for (int w = 0; w < planes.words(); ++w)
        for_runs_of_word(cursor, w, [&](std::uint32_t run, std::uint64_t mask) {
          if (!stays[run]) planes.plus(grid, j, k)[w] &= ~mask;
        });
    }
}

/// The cuts of a layer whose plus ends are left.
CutLayer cuts_left(const WarpedLattice& old, const SignPlanes& after, int k) {
  CutLayer left;
  RowRanks old_row, new_row;
  for (int j = 0; j < after.cells()[1]; ++j) {
    old_row.compute(old.planes, j, k);
    new_row.compute(after, j, k);
    left.row_begin.push_back(left.steps.size());
    for (std::size_t kind = corner_kinds; kind < kind_count; ++kind)
      for (int w = 0; w < new_row.words(); ++w)
        for_each_bit(new_row.mask(kind, w), [&](int b) {
          left.steps.push_back(static_cast<std::uint16_t>(
              old.cuts[k].at(j, old_row, old_row.rank(kind, w, b))));
        });
  }
  return left;
}

/// The displacements of the zero vertices of a layer that are left.
DisplacedLayer zeros_left(const WarpedLattice& old, const SignPlanes& after, int k) {
  DisplacedLayer left;
  std::size_t next = 0;
  for (int j = 0; j < after.cells()[1]; ++j) {
    left.row_begin.push_back(static_cast<std::uint32_t>(left.displacements.size()));
    for (const Grid grid : grids)
      for (int w = 0; w < after.words(); ++w) {
        const std::uint64_t zero = after.zero(grid, j, k)[w];
        for_each_bit(old.planes.zero(grid, j, k)[w], [&](int b) {
          const Displacement& own = old.zeros[k].displacements[next++];
          if ((zero >> b & 1) != 0) left.displacements.push_back(own);
        });
      }
  }
  return left;
}

}  // namespace

std::vector<bool> runs_that_stay(const PlusRuns& runs, const WarpedLattice& warped,
                                 const Lattice& lattice, const KeepRule& rule, Context& context) {
  JoinedRuns joined = join_runs(runs, warped, lattice, {}, context);
  const NumberedSets pieces = number_sets(joined.by_faces);
  const std::vector<bool> pieces_stay = std::visit(
      [&](const auto& which) { return choose(which, runs, pieces, context); }, rule);
  std::vector<bool> stays(runs.size());
  for (std::size_t run = 0; run < stays.size(); ++run) stays[run] = pieces_stay[pieces.of[run]];
  return stays;
}

WarpedLattice with_runs(const WarpedLattice& warped, const PlusRuns& runs,
                        const std::vector<bool>& stays, const Lattice& lattice,
                        Context& context) {
  const Window all = whole(lattice);
  SignPlanes after = warped.planes;
  for_each_layer(context, Stage::warp, all,
                 [&](std::int32_t k) { drop_runs(after, runs, stays, k); });
  drop_idle_zeros(after, all, context);
  Layers<CutLayer> cuts(all);
  Layers<DisplacedLayer> zeros(all);
  for_each_layer(context, Stage::warp, all, [&](std::int32_t k) {
    cuts[k] = cuts_left(warped, after, k);
    zeros[k] = zeros_left(warped, after, k);
  });
  return {std::move(after), std::move(cuts), std::move(zeros), warped.figures};
}

}  // namespace certet::core
