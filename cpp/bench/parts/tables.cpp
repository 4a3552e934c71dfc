/// What is decided for one tetrahedron or one vertex: stencil, lattice, warp.

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "certet/lattice/stencil.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/lattice/warp.hpp"

namespace {

using namespace certet;

void unstructured_tets_of_all_patterns(benchmark::State& state) {
  std::vector<CornerSigns> patterns;
  patterns.reserve(pattern_count);
  for (int i = 0; i < pattern_count; ++i) patterns.push_back(pattern_signs(i));
  for (auto _ : state)
    for (const CornerSigns& signs : patterns) {
      const Stencil* stencil = &unstructured_tets(signs);
      benchmark::DoNotOptimize(stencil);
    }
  state.SetItemsProcessed(state.iterations() * pattern_count);
}
BENCHMARK(unstructured_tets_of_all_patterns)->UseRealTime();

void structured_tet_of_all_cases(benchmark::State& state) {
  Coord3 anchor{0, 0, 0};
  for (auto _ : state) {
    benchmark::DoNotOptimize(anchor);
    for (int c = 0; c < case_count; ++c) {
      StructuredTet tet = structured_tet({anchor, static_cast<StructuredTetCase>(c)});
      benchmark::DoNotOptimize(tet);
    }
  }
  state.SetItemsProcessed(state.iterations() * case_count);
}
BENCHMARK(structured_tet_of_all_cases)->UseRealTime();

/// A vertex with cuts on some of its edges.
struct CutVertex {
  std::uint32_t cut_edges;
  std::array<std::int32_t, direction_count> cut;
};

std::vector<CutVertex> cut_vertices(int count) {
  std::mt19937 random(1);
  std::vector<CutVertex> vertices(static_cast<std::size_t>(count));
  for (CutVertex& v : vertices) {
    v.cut_edges = static_cast<std::uint32_t>(random()) & ((1U << direction_count) - 1);
    for (std::int32_t& c : v.cut)
      c = static_cast<std::int32_t>(random() % static_cast<unsigned>(steps));
  }
  return vertices;
}

void warp_of_cut_vertices(benchmark::State& state) {
  const std::vector<CutVertex> vertices = cut_vertices(1024);
  for (auto _ : state)
    for (const CutVertex& v : vertices) {
      Warping warping = warp(angle_thresholds, v.cut_edges, v.cut);
      benchmark::DoNotOptimize(warping);
    }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices.size()));
}
BENCHMARK(warp_of_cut_vertices)->UseRealTime();

}  // namespace
