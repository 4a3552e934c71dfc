/// \file
/// Graded meshes: the engine and the reference give the same tetrahedra, each with the same
/// four positions in the same order; which of them comes first is each one's own affair.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "domains.hpp"
#include "holes.hpp"
#include "placed_mesh.hpp"
#include "seed.hpp"
#include "seen.hpp"

namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Method;
using certified::PlacedTet;

/// The production side of the comparison.
using Engine =
    std::function<PlacedMesh(const domains::Positional&, const Lattice&, Method, int levels)>;

PlacedMesh engine(const domains::Positional& domain, const Lattice& lattice, Method method,
                  int levels) {
  certet::Context context;
  context.threads = 1;
  certet::Stuffing stuffing(domain, lattice, method, context);
  stuffing.grade({.levels = levels, .of_materials = {}, .at_points = {}}, context);
  PlacedMesh placed = placed_mesh(stuffing, context);
  std::ranges::sort(placed.tets);
  return placed;
}

std::vector<PlacedTet> reference(const domains::Positional& domain, const Lattice& lattice,
                                 Method method, int levels) {
  const certet::MethodFacts& facts = certet::facts(method);
  std::vector<PlacedTet> tets =
      certified::grade({facts.thresholds.long_edge, facts.thresholds.short_edge}, facts.settles,
                       levels, lattice, seen_by(method, domain), diagonals_of(method));
  std::ranges::sort(tets);
  return tets;
}

Differences compare(const Engine& production, const domains::Positional& domain,
                    const Lattice& lattice, Method method, int levels) {
  const PlacedMesh ours = production(domain, lattice, method, levels);
  return compare_tets(ours.tets, reference(domain, lattice, ours.method, levels));
}

const Lattice ball_lattice{{-14, -16, -12}, {15, 16, 14}};

domains::Positional ball() { return domains::of_level(domains::sphere(0.3, 0.2, 0.1, 11)); }

TEST(GradedMesh, OfABallIsTheSame) {
  for (const certet::MethodFacts& row : certet::methods)
    for (int levels = 1; levels <= certet::most_grading_levels; ++levels) {
      const Differences differences = compare(engine, ball(), ball_lattice, row.method, levels);
      EXPECT_TRUE(differences.empty()) << differences;
      EXPECT_GT(differences.compared(), 100);
    }
}

/// By no level the reference's mesh is that of `settle` or `stuff`.
TEST(GradedMesh, OfNoLevelIsTheUniformOne) {
  const Differences differences = compare(engine, ball(), ball_lattice, Method::embedded, 0);
  EXPECT_TRUE(differences.empty()) << differences;
}

/// A box with holes, somewhere.
Differences compare_random(const Engine& production, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto place = [&] { return 2 * between(random, -40, 40); };
  const auto extent = [&] { return between(random, 4, 12); };
  const Lattice lattice{{place(), place(), place()}, {extent(), extent(), extent()}};
  const domains::Positional domain =
      domains::with_holes(random, lattice, between(random, 0, 2), 3);
  const Method method = certet::methods[static_cast<std::size_t>(between(random, 0, 3))].method;
  return compare(production, domain, lattice, method, between(random, 1, 3));
}

TEST(GradedMesh, OfRandomDomainsIsTheSame) {
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    const Differences differences = compare_random(engine, trial_seed(test_seed(), trial));
    EXPECT_TRUE(differences.empty()) << "trial " << trial << ": " << differences;
  }
}

bool is_caught(const Engine& broken) {
  return !compare(broken, ball(), ball_lattice, Method::embedded, 2).empty();
}

Engine spoiled(const std::function<void(PlacedMesh&)>& spoil) {
  return [=](const auto& domain, const Lattice& lattice, Method method, int levels) {
    PlacedMesh mesh = engine(domain, lattice, method, levels);
    if (!mesh.tets.empty()) spoil(mesh);
    return mesh;
  };
}

TEST(GradedMesh, CatchesOneStepOfOneVertex) {
  EXPECT_TRUE(is_caught(spoiled([](PlacedMesh& m) { m.tets.back()[2].y += 1; })));
}

TEST(GradedMesh, CatchesAMissingTetrahedron) {
  EXPECT_TRUE(is_caught(spoiled([](PlacedMesh& m) { m.tets.erase(m.tets.begin() + 7); })));
}

TEST(GradedMesh, CatchesAMirroredTetrahedron) {
  EXPECT_TRUE(is_caught(spoiled([](PlacedMesh& m) { std::swap(m.tets[5][2], m.tets[5][3]); })));
}

TEST(GradedMesh, CatchesALevelThatIsForgotten) {
  EXPECT_TRUE(is_caught([](const auto& domain, const Lattice& lattice, Method method, int levels) {
    return engine(domain, lattice, method, levels - 1);
  }));
}

/// Cells are counted from the lattice, and not from where all lattices have their 0.
TEST(GradedMesh, CatchesAnOctreeInAnotherPlace) {
  EXPECT_TRUE(is_caught([](const domains::Positional& domain, Lattice lattice, Method method,
                           int levels) {
    const Coord3 by{2, 0, 0};
    const domains::Positional moved(
        [&](Coord3 p) { return domain.sign_at(p - certet::steps * by); });
    lattice.origin = lattice.origin + by;
    PlacedMesh mesh = engine(moved, lattice, method, levels);
    for (PlacedTet& tet : mesh.tets)
      for (Coord3& p : tet) p = p - certet::steps * by;
    std::ranges::sort(mesh.tets);
    return mesh;
  }));
}

}  // namespace
