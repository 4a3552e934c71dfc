#include "region_runs.hpp"

#include <algorithm>
#include <limits>

#include "certet/error.hpp"
#include "layer_loop.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// Calls visit(run) for the runs of a row.
template <class Visit>
void for_each_run(const SignPlanes& planes, Grid grid, int j, int k, const Visit& visit) {
  const std::uint64_t* const plus = planes.plus(grid, j, k);
  const MaterialPlanes& materials = *planes.materials();
  std::int32_t begin = 0;
  std::uint64_t parted_before = 0;
  for (int w = 0; w < planes.words(); ++w) {
    const std::uint64_t parted = plus[w] == 0 ? 0 : materials.parted_along(grid, j, k, w);
    const std::uint64_t starts =
        plus[w] & ~(shifted(plus, w, -1) & ~(parted << 1 | parted_before >> 63));
    const std::uint64_t ends = plus[w] & ~(shifted(plus, w, 1) & ~parted);
    for_each_bit(starts | ends, [&](int b) {
      if (starts >> b & 1) begin = 64 * w + b;
      if (ends >> b & 1) visit(RegionRun{begin, 64 * w + b + 1, materials.at(grid, begin, j, k)});
    });
    parted_before = parted;
  }
}

}  // namespace

RegionRuns::RegionRuns(const SignPlanes& planes, Context& context)
    : rows_(static_cast<std::size_t>(planes.cells()[1])),
      first_(at(even, 0, planes.cells()[2]) + 1) {
  const auto for_each_row = [&](std::int32_t k, const auto& visit) {
    for (int j = 0; j < planes.cells()[1]; ++j)
      for (const Grid grid : grids) visit(grid, j, at(grid, j, k));
  };
  for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
    for_each_row(k, [&](Grid grid, int j, std::size_t n) {
      std::uint32_t count = 0;
      for_each_run(planes, grid, j, k, [&](const RegionRun&) { ++count; });
      first_[n] = count;
    });
  });
  std::uint64_t total = 0;
  for (std::uint32_t& first : first_) {
    const std::uint32_t runs = first;
    first = static_cast<std::uint32_t>(total);
    total += runs;
  }
  if (total > std::numeric_limits<std::uint32_t>::max() / 2)
    throw Error(ErrorCode::too_large, "the mesh is too large for its pieces to be counted");
  runs_.resize(total);
  for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
    for_each_row(k, [&](Grid grid, int j, std::size_t n) {
      auto to = runs_.begin() + first_[n];
      for_each_run(planes, grid, j, k, [&](const RegionRun& run) { *to++ = run; });
    });
  });
}

std::uint32_t RegionRuns::run_of(const VertexIndex& v) const {
  const std::span<const RegionRun> runs = row(v.grid, v.j, v.k);
  const auto after = std::ranges::upper_bound(runs, v.i, {}, &RegionRun::begin);
  return first(v.grid, v.j, v.k) + static_cast<std::uint32_t>(after - runs.begin()) - 1;
}

}  // namespace certet::core
