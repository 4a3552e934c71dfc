/// \file
/// Graded meshes: the engine and the reference give the same tetrahedra, each with the same
/// four positions in the same order; which of them comes first is each one's own affair.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "certet/lattice/orientation.hpp"
#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "domains.hpp"
#include "holes.hpp"
#include "materials.hpp"
#include "placed_materials.hpp"
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

// -- Several materials --------------------------------------------------------------------

using MaterialEngine = std::function<MaterialMesh(const materials::Positional&, const Lattice&,
                                                  Method, int levels)>;

void sort(MaterialMesh& mesh) {
  std::ranges::sort(mesh, {}, [](const certified::PlacedMaterialTet& tet) {
    return std::pair(tet.vertices, tet.material);
  });
}

MaterialMesh material_engine(const materials::Positional& domain, const Lattice& lattice,
                             Method method, int levels) {
  certet::Context context;
  context.threads = 1;
  certet::Stuffing stuffing(domain, lattice, method, context);
  stuffing.grade({.levels = levels, .of_materials = {}, .at_points = {}}, context);
  MaterialMesh placed = placed_by_material(certet::emit(stuffing, {}, context));
  sort(placed);
  return placed;
}

Differences compare(const MaterialEngine& production, const materials::Positional& domain,
                    const Lattice& lattice, Method method, int levels) {
  const certet::Thresholds alpha = certet::facts(method).thresholds;
  MaterialMesh theirs = certified::grade_materials({alpha.long_edge, alpha.short_edge},
                                                   certet::facts(method).settles, levels, lattice,
                                                   seen_on(lattice, domain));
  sort(theirs);
  return compare_by_material(production(domain, lattice, method, levels), theirs);
}

/// A ball in two halves, of a material each.
const materials::Positional& halves() {
  static const materials::Positional domain({1, 2}, [](Coord3 p) -> certet::Material {
    constexpr double unit = certet::steps;
    const double x = p.x / unit, y = p.y / unit, z = p.z / unit;
    return domains::sphere(0.3, 0.2, 0.1, 11)(x, y, z) >= 0 ? 0 : x < -3.3 ? 1 : 2;
  });
  return domain;
}

TEST(GradedMesh, OfTwoHalvesIsTheSame) {
  for (const Method method : {Method::embedded, Method::midpoint}) {
    const Differences differences = compare(material_engine, halves(), ball_lattice, method, 2);
    EXPECT_TRUE(differences.empty()) << differences;
    EXPECT_GT(differences.compared(), 1000);
  }
}

/// Cubes of random materials, large and small.
TEST(GradedMesh, OfRandomMaterialsIsTheSame) {
  for (std::uint64_t trial = 0; trial < 8; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 50 + trial));
    const auto place = [&] { return 2 * between(random, -40, 40); };
    const auto extent = [&] { return between(random, 6, 10); };
    const Lattice lattice{{place(), place(), place()}, {extent(), extent(), extent()}};
    const materials::Positional domain = materials::cubes(
        random(), between(random, 5, 14), {1, 2, 3}, static_cast<unsigned>(between(random, 0, 90)));
    const Differences differences =
        compare(material_engine, domain, lattice,
                trial % 3 == 0 ? Method::midpoint : Method::embedded, between(random, 1, 3));
    EXPECT_TRUE(differences.empty()) << "trial " << trial << ": " << differences;
  }
}

TEST(GradedMesh, CatchesALargeTetrahedronOfAnotherMaterial) {
  const MaterialEngine broken = [](const materials::Positional& domain, const Lattice& lattice,
                                   Method method, int levels) {
    MaterialMesh mesh = material_engine(domain, lattice, method, levels);
    const auto volume = [](const certified::PlacedMaterialTet& tet) {
      const auto& [a, b, c, d] = tet.vertices;
      return certet::six_volume(a, b, c, d);
    };
    auto& largest = *std::ranges::max_element(mesh, {}, volume);
    largest.material = 3 - largest.material;
    sort(mesh);
    return mesh;
  };
  EXPECT_FALSE(compare(broken, halves(), ball_lattice, Method::midpoint, 2).empty());
}

}  // namespace
