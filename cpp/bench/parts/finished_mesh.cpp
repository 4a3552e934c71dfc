/// What is done with a finished mesh; items are its tetrahedra.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "certet/check.hpp"
#include "certet/formats.hpp"
#include "certet/quality.hpp"
#include "torus_mesh.hpp"

namespace {

using namespace certet;
using namespace certet::bench;

void count_tets(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(part_mesh_tets().size()));
}

void measure_in_lattice(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(measure_lattice(part_mesh().points, 0, part_mesh_tets()));
  count_tets(state);
}
BENCHMARK(measure_in_lattice)->UseRealTime();

void measure_in_world(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(measure_world(part_mesh_world(), 0, part_mesh_tets()));
  count_tets(state);
}
BENCHMARK(measure_in_world)->UseRealTime();

void check_mesh(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(check(part_mesh_world(), part_mesh_tets()));
  count_tets(state);
}
BENCHMARK(check_mesh)->UseRealTime();

/// Writes into the working folder, and leaves nothing there.
void write_vtu(benchmark::State& state) {
  const std::filesystem::path file = "certet_bench_parts.vtu";
  const MeshSize size{part_mesh_world().size(), part_mesh_tets().size(), false};
  for (auto _ : state) {
    const auto writer = open_writer(file, Format::vtu, size);
    writer->points(part_mesh_world());
    writer->tets(part_mesh_tets(), {});
    writer->finish();
  }
  count_tets(state);
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(file_bytes(Format::vtu, size)));
  std::filesystem::remove(file);
}
BENCHMARK(write_vtu)->UseRealTime();

}  // namespace
