#include "plus_runs.hpp"

#include <algorithm>
#include <limits>

#include "certet/error.hpp"
#include "layer_loop.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// Layers that one task joins, before the tasks' layers are joined to each other.
constexpr std::int32_t layers_per_block = 16;

}  // namespace

PlusRuns::PlusRuns(const SignPlanes& planes, Context& context)
    : planes_(planes), first_(at(even, 0, planes.cells()[2]) + 1) {
  for (std::vector<std::uint64_t>& words : starts_) words.resize(planes.layout().size());
  const auto for_each_row = [&](const auto& visit) {
    for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
      for (int j = 0; j < planes.cells()[1]; ++j)
        for (const Grid grid : grids) visit(grid, j, k);
    });
  };
  for_each_row([&](Grid grid, int j, int k) { first_[at(grid, j, k)] = find_starts(grid, j, k); });
  std::uint64_t total = 0;
  for (std::uint32_t& first : first_) {
    const std::uint32_t runs = first;
    first = static_cast<std::uint32_t>(total);
    total += runs;
  }
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorCode::too_large, "the mesh is too large for its pieces to be counted");
  if (!have_materials()) return;
  materials_.resize(total);
  for_each_row([&](Grid grid, int j, int k) { find_materials(grid, j, k); });
}

std::uint32_t PlusRuns::find_starts(Grid grid, int j, int k) {
  const std::uint64_t* const plus = planes_.plus(grid, j, k);
  std::uint64_t* const starts = &starts_[grid][planes_.layout().at(j, k)];
  std::uint32_t runs = 0;
  std::uint64_t before = 0;  // those that are plus, and of the same material as the next
  for (int w = 0; w < planes_.words(); ++w) {
    if (plus[w] == 0) {
      before = 0;
      continue;
    }
    const std::uint64_t same =
        have_materials() ? plus[w] & ~planes_.materials()->parted_along(grid, j, k, w) : plus[w];
    starts[w] = plus[w] & ~(same << 1 | before >> 63);
    runs += static_cast<std::uint32_t>(std::popcount(starts[w]));
    before = same;
  }
  return runs;
}

void PlusRuns::find_materials(Grid grid, int j, int k) {
  const std::uint64_t* const starts = &starts_[grid][planes_.layout().at(j, k)];
  std::uint32_t run = first(grid, j, k);
  for (int w = 0; w < planes_.words(); ++w)
    for_each_bit(starts[w], [&](int b) {
      materials_[run++] = planes_.materials()->at(grid, 64 * w + b, j, k);
    });
}

RunCursor PlusRuns::cursor(VertexRef ref, int j, int k) const {
  const int y = j + ref.shift.y;
  const int z = k + ref.shift.z;
  return {planes_.plus(ref.grid, y, z), &starts_[ref.grid][planes_.layout().at(y, z)],
          ref.shift.x, first(ref.grid, y, z)};
}

std::uint32_t PlusRuns::run_of(const VertexIndex& v) const {
  RunCursor row = cursor({v.grid, {}}, v.j, v.k);
  for (int w = 0; w <= v.i >> 6; ++w) row.next(w);
  return row.run(v.i & 63);
}

DisjointSets& PlusRuns::sets_of(std::uint32_t a, std::uint32_t b, RunSets& sets) const {
  return have_materials() && are_alike(a, b) ? sets.regions : sets.whole;
}

/// Where both rows have a plus vertex, two runs meet: of the bits at which the same two do,
/// one is enough.
void PlusRuns::join_rows(const RowEdges& edges, int j, int k, RunSets& sets) const {
  const auto& [from, to] = edges;
  const int y = j + to.shift.y;
  const int z = k + to.shift.z;
  const std::uint32_t a = first(from, j, k);
  const std::uint32_t b = first(to.grid, y, z);
  const std::uint32_t a_end = end(from, j, k);
  const std::uint32_t b_end = end(to.grid, y, z);
  if (a == a_end || b == b_end) return;
  const bool single = a_end - a == 1 && b_end - b == 1;
  if (single && sets_of(a, b, sets).find(a) == sets_of(a, b, sets).find(b)) return;
  RunCursor own = cursor({from, {}}, j, k);
  RunCursor other = cursor(to, j, k);
  std::uint64_t before = 0;
  for (int w = 0; w < planes_.words(); ++w) {
    const std::uint64_t plus = own.next(w);
    const std::uint64_t both = plus & other.next(w);
    const std::uint64_t meet = both & (run_starts(both, before) | own.starts() | other.starts());
    for_each_bit(meet, [&](int bit) {
      const std::uint32_t one = own.run(bit);
      const std::uint32_t two = other.run(bit);
      if (!edges.are_long() || are_alike(one, two)) sets_of(one, two, sets).join(one, two);
    });
    before = both;
    if (single && both != 0) return;
  }
}

void PlusRuns::join_layer(int k, std::int8_t layers, RunSets& sets) const {
  const int rows = planes_.cells()[1];
  for (const RowEdges& edges : edges_between_rows) {
    if (edges.to.shift.z != layers) continue;
    for (int j = std::max(0, -edges.to.shift.y); j < rows - std::max<int>(0, edges.to.shift.y); ++j)
      join_rows(edges, j, k, sets);
  }
}

RunSets PlusRuns::joined_by_edges(Context& context) const {
  RunSets sets{DisjointSets(size()), DisjointSets(have_materials() ? size() : 0)};
  const std::int32_t layers = planes_.cells()[2];
  const std::int32_t blocks = (layers + layers_per_block - 1) / layers_per_block;
  // The runs of a block are joined to none of another, so that threads do not meet.
  parallel_for(context, Stage::count, blocks, [&](std::int64_t block) {
    const auto begin = static_cast<std::int32_t>(block) * layers_per_block;
    const std::int32_t end = std::min(begin + layers_per_block, layers);
    for (std::int32_t k = begin; k < end; ++k) {
      join_layer(k, 0, sets);
      if (k + 1 < end) join_layer(k, 1, sets);
    }
  });
  for (std::int32_t k = layers_per_block; k < layers; k += layers_per_block)
    join_layer(k - 1, 1, sets);
  for (std::uint32_t run = 0; run < sets.regions.size(); ++run)
    sets.whole.join(run, sets.regions.find(run));
  return sets;
}

}  // namespace certet::core
