/// The stages of the engine, one thread; items are tetrahedra of the mesh.

#include <benchmark/benchmark.h>

#include "../stage_clock.hpp"
#include "torus_mesh.hpp"

namespace {

using namespace certet;
using namespace certet::bench;

/// Runs of the engine for each stage; a count by time would go by the stage's
/// share alone.
constexpr int repeats = 10;

/// The engine runs whole each time, and the stage's share of it is measured.
void stage(benchmark::State& state, Stage measured) {
  Context context;
  context.threads = 1;
  StageClock clock(context);
  std::uint64_t tets = 0;
  for (auto _ : state) {
    clock.start();
    const Mesh mesh = stuff(part_torus(), part_torus().lattice(), {}, {}, context);
    state.SetIterationTime(clock.stop()[static_cast<std::size_t>(measured)]);
    tets = mesh.tet_count();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets));
}
BENCHMARK_CAPTURE(stage, sample, Stage::sample)->UseManualTime()->Iterations(repeats);
BENCHMARK_CAPTURE(stage, cut, Stage::cut)->UseManualTime()->Iterations(repeats);
BENCHMARK_CAPTURE(stage, warp, Stage::warp)->UseManualTime()->Iterations(repeats);
BENCHMARK_CAPTURE(stage, count, Stage::count)->UseManualTime()->Iterations(repeats);
BENCHMARK_CAPTURE(stage, emit, Stage::emit)->UseManualTime()->Iterations(repeats);

void all_stages(benchmark::State& state) {
  Context context;
  context.threads = 1;
  std::uint64_t tets = 0;
  for (auto _ : state)
    tets = stuff(part_torus(), part_torus().lattice(), {}, {}, context).tet_count();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets));
}
BENCHMARK(all_stages)->UseRealTime();

}  // namespace
