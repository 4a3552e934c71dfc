#include "keep.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>

#include "displaced_left.hpp"
#include "layer_loop.hpp"
#include "joined_parts.hpp"
#include "piece_tets.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// Calls visit(run, j, w, mask) for the runs of the words of a layer and a grid.
template <class Visit>
void for_each_run(const PlusRuns& runs, Grid grid, int k, const Visit& visit) {
  for (int j = 0; j < runs.planes().cells()[1]; ++j) {
    RunCursor cursor = runs.cursor({grid, {}}, j, k);
    for (int w = 0; w < runs.planes().words(); ++w)
      for (std::uint64_t plus = cursor.next(w); plus != 0;) {
        const int b = std::countr_zero(plus);
        const std::uint64_t mask = cursor.rest_of_run(b);
        visit(cursor.run(b), j, w, mask);
        plus &= ~mask;
      }
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
  std::vector<Reach> reach(pieces.count);
  for (int k = 0; k < runs.planes().cells()[2]; ++k)
    for (const Grid grid : grids)
      for_each_run(runs, grid, k, [&](std::uint32_t run, int j, int w, std::uint64_t mask) {
        for (const int b : {std::countr_zero(mask), static_cast<int>(std::bit_width(mask)) - 1}) {
          const Coord3 at = 2 * Coord3{64 * w + b, j, k} + tiling.grids[grid];
          reach[pieces.of[run]].add(std::array{at.x, at.y, at.z}[axis]);
        }
      });
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

/// Once vertices are taken out: the points that are left.
WarpedLattice what_is_left(const WarpedLattice& warped, SignPlanes after, const Lattice& lattice,
                           Context& context) {
  const Window all = whole(lattice);
  drop_idle_zeros(after, all, context);
  Layers<CutLayer> cuts(all);
  Layers<DisplacedLayer> zeros(all);
  for_each_layer(context, Stage::warp, all, [&](std::int32_t k) {
    cuts[k] = cuts_left(warped, after, k);
    zeros[k] = displaced_left(
        warped.zeros[k], [&](Grid grid, int j) { return warped.planes.zero(grid, j, k); }, after, k);
  });
  return {std::move(after), std::move(cuts), std::move(zeros), warped.figures,
          warped.diagonals_follow_cuts};
}

/// Of each part, whether it stays.
std::vector<bool> parts_that_stay(MeshParts& parts, const KeepRule& rule, Context& context) {
  const NumberedSets pieces = number_sets(parts.whole.by_faces);
  const std::vector<bool> pieces_stay = std::visit(
      [&]<class Rule>(const Rule& which) {
        if constexpr (std::is_same_v<Rule, KeepLargest>)
          return choose(which, count_tets_of_pieces(parts, pieces, context));
        else
          return choose(reaches(parts.runs, pieces, which.axis));
      },
      rule);
  std::vector<bool> stays;
  stays.reserve(pieces.of.size());
  for (const std::uint32_t piece : pieces.of) stays.push_back(pieces_stay[piece]);
  return stays;
}

/// The materials of zero vertices count where a tetrahedron has four of them: those of
/// tetrahedra that do not stay are of none.
void drop_zero_tets(MaterialPlanes& materials, const MeshParts& parts,
                    const std::vector<bool>& stays) {
  const auto set_corners = [&](std::uint32_t part, Material material) {
    const CaseIndex& tet = parts.zero_tets[part - parts.runs.size()];
    for (std::size_t n = 0; n < 4; ++n) {
      const VertexIndex v = tet.corner(n);
      materials.set(v.grid, v.i, v.j, v.k, material);
    }
  };
  const auto for_each_zero_tet = [&](bool which, const auto& visit) {
    for (std::uint32_t part = parts.runs.size(); part < parts.size(); ++part)
      if (stays[part] == which) visit(part);
  };
  for_each_zero_tet(false, [&](std::uint32_t part) { set_corners(part, 0); });
  // Some corners are also those of others.
  for_each_zero_tet(true, [&](std::uint32_t part) { set_corners(part, parts.material(part)); });
}

WarpedLattice with_parts(const WarpedLattice& warped, const MeshParts& parts,
                         const std::vector<bool>& stays, const Lattice& lattice,
                         Context& context) {
  SignPlanes after = warped.planes;
  const MaterialPlanes* const before = warped.planes.materials();
  const auto materials = before ? std::make_shared<MaterialPlanes>(*before) : nullptr;
  for_each_layer(context, Stage::warp, whole(lattice), [&](std::int32_t k) {
    for (const Grid grid : grids)
      for_each_run(parts.runs, grid, k, [&](std::uint32_t run, int j, int w, std::uint64_t mask) {
        if (stays[run]) return;
        after.plus(grid, j, k)[w] &= ~mask;
        if (materials) materials->clear(grid, j, k, w, mask);
      });
  });
  if (materials) drop_zero_tets(*materials, parts, stays);
  after.set_materials(materials);
  return what_is_left(warped, std::move(after), lattice, context);
}

}  // namespace

SplitLattice split(const WarpedLattice& warped, const Lattice& lattice, const KeepRule& rule,
                   Context& context) {
  MeshParts parts = join_parts(warped.planes, context);
  std::vector<bool> stays = parts_that_stay(parts, rule, context);
  WarpedLattice kept = with_parts(warped, parts, stays, lattice, context);
  stays.flip();
  return {std::move(kept), with_parts(warped, parts, stays, lattice, context)};
}

}  // namespace certet::core
