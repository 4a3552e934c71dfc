/// Runs of cells: what is measured as a run has the figures that it has tetrahedron by tetrahedron.
#include "cell_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "certet/certet.hpp"
#include "certet/quality.hpp"
#include "same_quality.hpp"

namespace certet {
namespace {

using Tet32 = Tet<std::uint32_t>;
using Runs = std::vector<std::pair<std::size_t, std::size_t>>;

Mesh ball(double radius) {
  return mesh(BoundedFunction([=](Point3 p) { return std::hypot(p[0], p[1], p[2]) - radius; },
                              {{-1, -1, -1}, {1, 1, 1}}, 0.08));
}

std::span<const Tet32> tets_of(const Mesh& mesh) {
  return std::get<Buffer<Tet32>>(mesh.tets);
}

Runs runs_of(const Mesh& mesh) {
  const std::span<const Tet32> tets = tets_of(mesh);
  Runs runs;
  std::size_t seen = 0;
  core::CellRuns<std::uint32_t>(mesh.points, 0, tets)
      .for_each(
          [&](std::size_t begin, std::size_t cells) {
            EXPECT_EQ(begin, seen);
            seen += cells * core::cell_tet_count;
            runs.emplace_back(begin, cells);
          },
          [&](std::size_t begin, std::size_t count) {
            EXPECT_EQ(begin, seen);
            seen += count;
          });
  EXPECT_EQ(seen, tets.size());
  return runs;
}

/// By what the first of a run has to be moved to be the tetrahedron of another cell.
void expect_translates(const Mesh& mesh, const Runs& runs) {
  const std::span<const Tet32> tets = tets_of(mesh);
  for (const auto& [begin, cells] : runs)
    for (std::size_t n = 0; n < cells * core::cell_tet_count; ++n) {
      const auto cell = static_cast<std::int32_t>(n / core::cell_tet_count);
      for (std::size_t v = 0; v < 4; ++v) {
        Coord3 first = mesh.points[tets[begin + n % core::cell_tet_count][v]];
        first.x += cell * 2 * steps;
        ASSERT_EQ(mesh.points[tets[begin + n][v]], first);
      }
    }
}

/// No run is left when neighbours in the list are no neighbours in a row.
Quality one_by_one(const Mesh& mesh, std::uint64_t seed) {
  const std::span<const Tet32> ordered = tets_of(mesh);
  std::vector<Tet32> tets(ordered.begin(), ordered.end());
  std::mt19937_64 random(seed);
  std::ranges::shuffle(tets, random);
  return measure_lattice(mesh.points, 0, std::span<const Tet32>(tets));
}

TEST(CellRuns, AreTranslatesAndMostOfABall) {
  const Mesh mesh = ball(0.9);
  const Runs runs = runs_of(mesh);
  std::size_t cells = 0;
  for (const auto& run : runs) cells += run.second;
  EXPECT_GT(cells * core::cell_tet_count, tets_of(mesh).size() / 2);
  expect_translates(mesh, runs);
}

TEST(CellRuns, MeasureAsTetrahedraDoOneByOne) {
  const Mesh mesh = ball(0.9);
  expect_same(measure_lattice(mesh.points, 0, tets_of(mesh)),
              one_by_one(mesh, 5));
}

TEST(CellRuns, EndWhereAPointHasMoved) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  Mesh mesh = ball(0.9);
  std::uniform_int_distribution<std::size_t> any(0, mesh.points.size() - 1);
  for (int i = 0; i < 50; ++i) {
    Coord3& moved = mesh.points[any(random)];
    const Coord3 before = moved;
    (i % 3 == 0 ? moved.x : i % 3 == 1 ? moved.y : moved.z) += 1 + i % 7;
    expect_translates(mesh, runs_of(mesh));
    const Quality quality =
        measure_lattice(mesh.points, 0, tets_of(mesh));
    expect_same(quality, one_by_one(mesh, seed));
    moved = before;
  }
}

TEST(CellRuns, EndWhereANumberIsWrong) {
  Mesh mesh = ball(0.9);
  const Runs runs = runs_of(mesh);
  const auto longest = std::ranges::max_element(runs, {}, &Runs::value_type::second);
  ASSERT_GT(longest->second, 3u);
  auto& tets = std::get<Buffer<Tet32>>(mesh.tets);
  std::swap(tets[longest->first + 2 * core::cell_tet_count + 5][0],
            tets[longest->first + 2 * core::cell_tet_count + 5][1]);
  expect_translates(mesh, runs_of(mesh));
  const Quality quality = measure_lattice(mesh.points, 0, tets_of(mesh));
  EXPECT_EQ(quality.nonpositive, 1u);
  expect_same(quality, one_by_one(mesh, 3));
}

TEST(CellRuns, OfNothingAreNone) {
  const std::vector<Coord3> points;
  const std::vector<Tet32> tets;
  EXPECT_EQ(measure_lattice(points, 0, std::span<const Tet32>(tets)).tets, 0u);
}

}  // namespace
}  // namespace certet
