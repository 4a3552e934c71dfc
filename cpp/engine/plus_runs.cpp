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

std::uint32_t count_runs(const std::uint64_t* row, int words) {
  std::uint32_t runs = 0;
  std::uint64_t before = 0;
  for (int w = 0; w < words; ++w) {
    runs += static_cast<std::uint32_t>(std::popcount(run_starts(row[w], before)));
    before = row[w];
  }
  return runs;
}

}  // namespace

PlusRuns::PlusRuns(const SignPlanes& planes, Context& context)
    : planes_(planes), first_(at(even, 0, planes.cells()[2]) + 1) {
  for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
    for (int j = 0; j < planes.cells()[1]; ++j)
      for (const Grid grid : grids)
        first_[at(grid, j, k)] = count_runs(planes.plus(grid, j, k), planes.words());
  });
  std::uint64_t total = 0;
  for (std::uint32_t& first : first_) {
    const std::uint32_t runs = first;
    first = static_cast<std::uint32_t>(total);
    total += runs;
  }
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorCode::too_large, "the mesh is too large for its pieces to be counted");
}

std::uint32_t PlusRuns::run_of(Grid grid, int i, int j, int k) const {
  RunCursor cursor(planes_.plus(grid, j, k), 0, first(grid, j, k));
  for (int w = 0; w <= i >> 6; ++w) cursor.next(w);
  return cursor.run(i & 63);
}

/// Where both rows have a plus vertex, two runs meet: the bits that they share are a run
/// themselves, and one of them is enough.
void PlusRuns::join_rows(const RowEdges& edges, int j, int k, DisjointSets& sets) const {
  const auto& [from, to] = edges;
  const int y = j + to.shift.y;
  const int z = k + to.shift.z;
  const std::uint32_t a = first(from, j, k);
  const std::uint32_t b = first(to.grid, y, z);
  const std::uint32_t a_end = end(from, j, k);
  const std::uint32_t b_end = end(to.grid, y, z);
  if (a == a_end || b == b_end) return;
  const bool single = a_end - a == 1 && b_end - b == 1;
  if (single && sets.find(a) == sets.find(b)) return;
  RunCursor own(planes_.plus(from, j, k), 0, a);
  RunCursor other(planes_.plus(to.grid, y, z), to.shift.x, b);
  std::uint64_t before = 0;
  for (int w = 0; w < planes_.words(); ++w) {
    const std::uint64_t plus = own.next(w);
    const std::uint64_t both = plus & other.next(w);
    for_each_bit(run_starts(both, before),
                 [&](int bit) { sets.join(own.run(bit), other.run(bit)); });
    before = both;
    if (single && both != 0) return;
  }
}

void PlusRuns::join_layer(int k, std::int8_t layers, DisjointSets& sets) const {
  const int rows = planes_.cells()[1];
  for (const RowEdges& edges : edges_between_rows) {
    if (edges.to.shift.z != layers) continue;
    for (int j = std::max(0, -edges.to.shift.y); j < rows - std::max<int>(0, edges.to.shift.y); ++j)
      join_rows(edges, j, k, sets);
  }
}

DisjointSets PlusRuns::joined_by_edges(Context& context) const {
  DisjointSets sets(size());
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
  return sets;
}

}  // namespace certet::core
