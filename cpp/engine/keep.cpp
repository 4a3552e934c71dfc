#include "keep.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>

#include "layer_loop.hpp"
#include "piece_count.hpp"
#include "plus_runs.hpp"
#include "region_pieces.hpp"
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
std::vector<bool> choose(const KeepLargest& rule, const std::vector<std::uint64_t>& tets) {
  std::vector<std::uint32_t> order(tets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](std::uint32_t piece) { return tets[piece]; });
  std::vector<bool> stays(tets.size(), false);
  for (std::size_t n = 0; n < std::min<std::uint64_t>(rule.count, order.size()); ++n)
    stays[order[n]] = true;
  return stays;
}

std::vector<bool> choose(const std::vector<Reach>& reach) {
  constexpr std::int32_t tolerance = 2;  // a long edge
  Reach all;
  for (const Reach& piece : reach) {
    if (piece.low > piece.high) continue;
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

/// The cuts of a layer whose plus ends are left.  One is measured from its other end
/// where that one's material was the greater, and does not stay.
CutLayer cuts_left(const WarpedLattice& old, const SignPlanes& after, int k) {
  CutLayer left;
  RowRanks old_row, new_row;
  for (int j = 0; j < after.cells()[1]; ++j) {
    old_row.compute(old.planes, j, k);
    new_row.compute(after, j, k);
    left.row_begin.push_back(left.steps.size());
    for (std::size_t kind = corner_kinds; kind < kind_count; ++kind)
      for (int w = 0; w < new_row.words(); ++w) {
        const std::uint64_t mask = new_row.mask(kind, w);
        if (mask == 0) continue;
        const std::uint64_t turned =
            old.planes.measured_from_first(kind - corner_kinds, j, k, w) ^
            after.measured_from_first(kind - corner_kinds, j, k, w);
        for_each_bit(mask, [&](int b) {
          const std::int32_t cut = old.cuts[k].at(j, old_row, old_row.rank(kind, w, b));
          left.steps.push_back(
              static_cast<std::uint16_t>((turned >> b & 1) != 0 ? steps - cut : cut));
        });
      }
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

/// Once vertices are taken out: the points that are left.
WarpedLattice what_is_left(const WarpedLattice& warped, SignPlanes after, const Lattice& lattice,
                           Context& context) {
  const Window all = whole(lattice);
  drop_idle_zeros(after, all, context);
  Layers<CutLayer> cuts(all);
  Layers<DisplacedLayer> zeros(all);
  for_each_layer(context, Stage::warp, all, [&](std::int32_t k) {
    cuts[k] = cuts_left(warped, after, k);
    zeros[k] = zeros_left(warped, after, k);
  });
  return {std::move(after), std::move(cuts), std::move(zeros), warped.figures};
}

/// Calls visit(run, v) for every vertex of every run.
template <class Visit>
void for_each_run_place(const RegionRuns& runs, const SignPlanes& planes, const Visit& visit) {
  for (std::int32_t k = 0; k < planes.cells()[2]; ++k)
    for (std::int32_t j = 0; j < planes.cells()[1]; ++j)
      for (const Grid grid : grids) {
        std::uint32_t run = runs.first(grid, j, k);
        for (const RegionRun& row : runs.row(grid, j, k)) {
          for (std::int32_t i = row.begin; i < row.end; ++i) visit(run, VertexIndex{grid, i, j, k});
          ++run;
        }
      }
}

std::vector<Reach> reaches(const RegionRuns& runs, const SignPlanes& planes,
                           const NumberedSets& pieces, std::size_t axis) {
  std::vector<Reach> reach(pieces.count);
  for_each_run_place(runs, planes, [&](std::uint32_t run, const VertexIndex& v) {
    const Coord3 at = 2 * Coord3{v.i, v.j, v.k} + tiling.grids[v.grid];
    reach[pieces.of[run]].add(std::array{at.x, at.y, at.z}[axis]);
  });
  return reach;
}

std::vector<bool> runs_that_stay(const PlusRuns& runs, const WarpedLattice& warped,
                                 const Lattice& lattice, const KeepRule& rule, Context& context) {
  JoinedRuns joined = join_runs(runs, warped, lattice, {}, context);
  const NumberedSets pieces = number_sets(joined.by_faces);
  const std::vector<bool> pieces_stay = std::visit(
      [&]<class Rule>(const Rule& which) {
        if constexpr (std::is_same_v<Rule, KeepLargest>)
          return choose(which, count_tets_of_pieces(runs, pieces.of, pieces.count, context));
        else
          return choose(reaches(runs, pieces, which.axis));
      },
      rule);
  std::vector<bool> stays(runs.size());
  for (std::size_t run = 0; run < stays.size(); ++run) stays[run] = pieces_stay[pieces.of[run]];
  return stays;
}

WarpedLattice with_runs(const WarpedLattice& warped, const PlusRuns& runs,
                        const std::vector<bool>& stays, const Lattice& lattice,
                        Context& context) {
  SignPlanes after = warped.planes;
  for_each_layer(context, Stage::warp, whole(lattice),
                 [&](std::int32_t k) { drop_runs(after, runs, stays, k); });
  return what_is_left(warped, std::move(after), lattice, context);
}

std::vector<bool> regions_that_stay(const RegionRuns& runs, JoinedRegions& joined,
                                    const SignPlanes& planes, const KeepRule& rule) {
  const NumberedSets pieces = number_sets(joined.by_faces);
  const std::vector<bool> pieces_stay = std::visit(
      [&]<class Rule>(const Rule& which) {
        if constexpr (std::is_same_v<Rule, KeepLargest>)
          return choose(which,
                        count_tets_of_regions(runs, joined, planes, pieces.of, pieces.count));
        else
          return choose(reaches(runs, planes, pieces, which.axis));
      },
      rule);
  std::vector<bool> stays;
  for (const std::uint32_t piece : pieces.of) stays.push_back(pieces_stay[piece]);
  return stays;
}

WarpedLattice with_regions(const WarpedLattice& warped, const RegionRuns& runs,
                           const JoinedRegions& joined, const std::vector<bool>& stays,
                           const Lattice& lattice, Context& context) {
  SignPlanes after = warped.planes;
  auto materials = std::make_shared<MaterialPlanes>(*warped.planes.materials());
  const auto take_out = [&](const VertexIndex& v) { materials->set(v.grid, v.i, v.j, v.k, 0); };
  for_each_run_place(runs, warped.planes, [&](std::uint32_t run, const VertexIndex& v) {
    if (stays[run]) return;
    after.plus(v.grid, v.j, v.k)[v.i >> 6] &= ~(std::uint64_t{1} << (v.i & 63));
    take_out(v);
  });
  // Of zero vertices their material counts where a tetrahedron has four of them.
  std::vector<std::pair<VertexIndex, Material>> kept;
  for (std::size_t n = 0; n < joined.shared.size(); ++n)
    for (const VertexIndex& v : joined.shared[n])
      if (stays[runs.size() + n]) kept.emplace_back(v, joined.materials[runs.size() + n]);
      else take_out(v);
  for (const auto& [v, material] : kept) materials->set(v.grid, v.i, v.j, v.k, material);
  after.set_materials(std::move(materials));
  return what_is_left(warped, std::move(after), lattice, context);
}

}  // namespace

SplitLattice split_runs(const WarpedLattice& warped, const Lattice& lattice, const KeepRule& rule,
                        Context& context) {
  const PlusRuns runs(warped.planes, context);
  std::vector<bool> stays = runs_that_stay(runs, warped, lattice, rule, context);
  WarpedLattice kept = with_runs(warped, runs, stays, lattice, context);
  stays.flip();
  return {std::move(kept), with_runs(warped, runs, stays, lattice, context)};
}

SplitLattice split_regions(const WarpedLattice& warped, const Lattice& lattice,
                           const KeepRule& rule, Context& context) {
  const RegionRuns runs(warped.planes, context);
  JoinedRegions joined = join_regions(runs, warped, lattice, {}, context);
  std::vector<bool> stays = regions_that_stay(runs, joined, warped.planes, rule);
  WarpedLattice kept = with_regions(warped, runs, joined, stays, lattice, context);
  stays.flip();
  return {std::move(kept), with_regions(warped, runs, joined, stays, lattice, context)};
}

}  // namespace certet::core
