/// \file
/// Graded meshes: the engine and the reference give the same tetrahedra, each with the same
/// four positions in the same order; which of them comes first is each one's own affair.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <sstream>
#include <vector>

#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "domains.hpp"
#include "seed.hpp"
#include "seen.hpp"

namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Method;
using certified::PlacedTet;

struct PlacedMesh {
  std::vector<PlacedTet> tets;  ///< sorted
  Method method{};
};

/// The production side of the comparison.
using Engine =
    std::function<PlacedMesh(const domains::Positional&, const Lattice&, Method, int levels)>;

PlacedMesh engine(const domains::Positional& domain, const Lattice& lattice, Method method,
                  int levels) {
  certet::Context context;
  context.threads = 1;
  certet::Stuffing stuffing(domain, lattice, method, context);
  stuffing.grade({.levels = levels, .of_materials = {}, .at_points = {}}, context);
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  PlacedMesh placed{{}, stuffing.method()};
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets)
          placed.tets.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
      },
      mesh.tets);
  std::ranges::sort(placed.tets);
  return placed;
}

std::vector<PlacedTet> reference(const domains::Positional& domain, const Lattice& lattice,
                                 Method method, int levels) {
  const certet::MethodFacts& facts = certet::facts(method);
  std::vector<PlacedTet> tets =
      certified::grade({facts.thresholds.long_edge, facts.thresholds.short_edge}, facts.settles,
                       levels, lattice, seen_by(method, domain));
  std::ranges::sort(tets);
  return tets;
}

Differences compare(const Engine& production, const domains::Positional& domain,
                    const Lattice& lattice, Method method, int levels) {
  Differences differences;
  const PlacedMesh ours = production(domain, lattice, method, levels);
  const std::vector<PlacedTet> theirs = reference(domain, lattice, ours.method, levels);
  differences.expect(ours.tets.size() == theirs.size(), [&] {
    std::ostringstream out;
    out << ours.tets.size() << " tetrahedra instead of " << theirs.size();
    return out.str();
  });
  for (std::size_t i = 0; i < std::min(ours.tets.size(), theirs.size()); ++i)
    differences.expect(ours.tets[i] == theirs[i], [&] {
      std::ostringstream out;
      out << "tetrahedron " << i;
      for (const auto* tet : {&ours.tets[i], &theirs[i]}) {
        out << (tet == &theirs[i] ? " instead of" : ":");
        for (const Coord3 v : *tet) out << " (" << v.x << ' ' << v.y << ' ' << v.z << ')';
      }
      return out.str();
    });
  return differences;
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
  std::vector<domains::Level> holes;
  for (int n = between(random, 0, 2); n > 0; --n) {
    const auto at = [&](std::int32_t from, std::int32_t cells) {
      return from + std::uniform_real_distribution(0.0, 2.0 * cells)(random);
    };
    holes.push_back(domains::sphere(at(lattice.origin.x, lattice.cells[0]),
                                    at(lattice.origin.y, lattice.cells[1]),
                                    at(lattice.origin.z, lattice.cells[2]),
                                    std::uniform_real_distribution(0.2, 3.0)(random)));
  }
  const domains::Positional domain = domains::of_level([holes](double x, double y, double z) {
    double level = -1;
    for (const domains::Level& hole : holes) level = std::max(level, -hole(x, y, z));
    return level;
  });
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
