/// \file
/// Whole meshes: the engine and the reference mesher give the same tetrahedra,
/// in the same order, each with the same four positions.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <functional>
#include <sstream>

#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "domains.hpp"
#include "placed_mesh.hpp"
#include "seen.hpp"

namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Method;
using certet::Sign;
using certified::PlacedTet;

/// The production side of the comparison.
using Engine = std::function<PlacedMesh(const domains::Positional&, const Lattice&,
                                        Method)>;

PlacedMesh engine(const domains::Positional& domain, const Lattice& lattice,
                  Method method) {
  certet::Context context;
  context.threads = 1;
  const certet::Stuffing stuffing(domain, lattice, method, context);
  return placed_mesh(stuffing, context);
}

std::vector<PlacedTet> reference(const domains::Positional& domain, const Lattice& lattice,
                                 Method method) {
  const certet::Thresholds thresholds = certet::facts(method).thresholds;
  const certified::Domain seen = seen_by(method, domain);
  const certified::Thresholds alpha{thresholds.long_edge, thresholds.short_edge};
  return certet::facts(method).settles
             ? certified::settle(alpha, certified::Gap::level, lattice, seen,
                                 diagonals_of(method))
             : certified::stuff(alpha, lattice, seen);
}

Differences compare(const Engine& production, const domains::Positional& domain,
                    const Lattice& lattice, Method method) {
  const PlacedMesh ours = production(domain, lattice, method);
  return compare_tets(ours.tets, reference(domain, lattice, ours.method));
}

void expect_same(const domains::Positional& domain, const Lattice& lattice) {
  for (const certet::MethodFacts& row : certet::methods) {
    const Differences differences = compare(engine, domain, lattice, row.method);
    EXPECT_TRUE(differences.empty()) << differences;
    EXPECT_GT(differences.compared(), 100);
  }
}

TEST(Mesh, OfASphereIsTheSame) {
  expect_same(domains::of_level(domains::sphere(1.37, -2.81, 0.59, 5.3)), {{-6, -10, -6}, {9, 9, 8}});
}

TEST(Mesh, OfATorusIsTheSame) {
  expect_same(domains::of_level(domains::torus(0.3, 0.2, 0.1, 5.1, 2.3)), {{-8, -8, -4}, {9, 9, 5}});
}

TEST(Mesh, OfABoxThroughLatticePointsIsTheSame) {
  expect_same(domains::of_level(domains::box(-4, 4)), {{-8, -8, -8}, {9, 9, 9}});
}

TEST(Mesh, OfADomainThatLeavesTheLatticeIsTheSame) {
  expect_same(domains::of_level(domains::sphere(0, 0, 0, 9)), {{-4, -6, -4}, {6, 7, 5}});
}

TEST(Mesh, FarFromTheOriginIsTheSame) {
  const std::int32_t far = certet::anchor_limit - 20;
  expect_same(domains::of_level(domains::sphere(far + 6.1, 5.7 - far, far + 6.2, 3.3)),
              {{far, -far, far}, {6, 6, 6}});
}

/// A row of more than 64 points crosses the words of a bit plane.
TEST(Mesh, OfALongRodIsTheSame) {
  expect_same(domains::of_level([](double x, double y, double z) {
                return std::hypot(y - 3.1, z - 2.9 - 0.01 * x) - 1.4;
              }),
              {{0, 0, 0}, {70, 4, 5}});
}

/// Cuts on, just below and just above each threshold seen from either end, and
/// at both ends of the edge.
std::vector<std::int32_t> boundary_cuts() {
  std::vector<std::int32_t> cuts{0, 1, certet::steps / 2, certet::steps - 1};
  for (const certet::Thresholds t : {certet::angle_thresholds, certet::embedding_thresholds,
                                   certet::key_thresholds})
    for (const int direction : {0, 6})
      for (const std::int32_t beside : {-1, 0, 1}) {
        cuts.push_back(t.in_steps(direction) + beside);
        cuts.push_back(certet::steps - t.in_steps(direction) + beside);
      }
  return cuts;
}

domains::Positional random_domain(std::uint64_t seed) {
  const unsigned zeros = std::array{0U, 20U, 100U}[seed / 3 % 3];
  switch (seed % 3) {
    case 0: return domains::noise(seed, zeros);
    case 1: return domains::random_cuts(seed, zeros, boundary_cuts());
    default: return domains::random_cuts(seed, zeros, {seed / 9 % 2 == 0 ? 0 : certet::steps - 1});
  }
}

/// Where the thresholds of `angles` invert a tetrahedron that is dropped, the
/// engine warps anew with those of `embedding`.
TEST(Mesh, OfALatticeThatFoldsIsTheSame) {
  const std::int32_t near = certet::angle_thresholds.in_steps(0) - 1;
  constexpr std::int32_t middle = certet::steps / 2;
  const domains::Positional domain =
      domains::random_cuts(4, 0, {near, certet::steps - near, middle, middle});
  const Lattice lattice{{0, 0, 0}, {12, 12, 12}};
  certet::Context context;
  const certet::Stuffing stuffing(domain, lattice, Method::angles, context);
  EXPECT_GT(stuffing.inverted_tets(), 0U);
  EXPECT_EQ(stuffing.method(), Method::embedding);
  const Differences differences = compare(engine, domain, lattice, Method::angles);
  EXPECT_TRUE(differences.empty()) << differences;
}

bool survives_random_domains(const Engine& production) {
  return rc::check("random domains give the same mesh", [&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const Method method = *rc::gen::element(Method::embedded, Method::angles, Method::embedding,
                                            Method::midpoint, Method::key);
    const auto extent = rc::gen::inRange(3, 9);
    const auto place = rc::gen::map(rc::gen::inRange(-50, 50), [](int c) { return 2 * c; });
    const Lattice lattice{{*place, *place, *place}, {*extent, *extent, *extent}};
    const Differences differences =
        compare(production, random_domain(seed), lattice, method);
    if (!differences.empty()) {
      std::ostringstream out;
      out << "seed " << seed << ": " << differences;
      RC_FAIL(out.str());
    }
  });
}

TEST(Mesh, OfRandomDomainsIsTheSame) { EXPECT_TRUE(survives_random_domains(engine)); }

/// Each planted bug changes the mesh that the engine gave.
Engine spoiled(const std::function<void(PlacedMesh&)>& spoil) {
  return [=](const auto& domain, const Lattice& lattice, Method method) {
    PlacedMesh mesh = engine(domain, lattice, method);
    if (!mesh.tets.empty()) spoil(mesh);
    return mesh;
  };
}

bool caught(const Engine& broken) {
  return !compare(broken, domains::of_level(domains::sphere(0.3, 0.2, 0.1, 3.1)),
                  {{-4, -4, -4}, {5, 5, 5}}, Method::angles)
              .empty();
}

TEST(Mesh, CatchesOneStepOfOneVertex) {
  EXPECT_TRUE(caught(spoiled([](PlacedMesh& m) { m.tets.back()[2].y += 1; })));
}

TEST(Mesh, CatchesATetrahedronOutOfOrder) {
  EXPECT_TRUE(caught(spoiled([](PlacedMesh& m) { std::swap(m.tets[0], m.tets[1]); })));
}

TEST(Mesh, CatchesAMissingTetrahedron) {
  EXPECT_TRUE(caught(spoiled([](PlacedMesh& m) { m.tets.pop_back(); })));
}

TEST(Mesh, CatchesAMirroredTetrahedron) {
  EXPECT_TRUE(caught(spoiled([](PlacedMesh& m) { std::swap(m.tets[5][2], m.tets[5][3]); })));
}

/// The surface is found one step too near: a bisection that loses a round.
TEST(Mesh, CatchesABisectionThatIsOneStepOff) {
  const Engine broken = [](const domains::Positional& domain, const Lattice& lattice,
                           Method method) {
    const domains::Positional shifted([&](Coord3 p) {
      const auto even = [](std::int32_t c) { return c & ~1; };
      return domain.sign_at({even(p.x), even(p.y), even(p.z)});
    });
    return engine(shifted, lattice, method);
  };
  EXPECT_TRUE(caught(broken));
  EXPECT_FALSE(survives_random_domains(broken));
}

/// The diagonals are those of the Parity Rule, all else is right.
TEST(Mesh, CatchesDiagonalsByParity) {
  const domains::Positional ball = domains::of_level(domains::sphere(0.3, 0.2, 0.1, 3.1));
  const Lattice lattice{{-4, -4, -4}, {5, 5, 5}};
  const certet::Thresholds t = certet::key_thresholds;
  EXPECT_FALSE(compare_tets(engine(ball, lattice, Method::key).tets,
                            certified::settle({t.long_edge, t.short_edge}, certified::Gap::level,
                                              lattice, seen_by(Method::key, ball)))
                   .empty());
}

/// The mesh was not warped with the thresholds of the method that it names.
TEST(Mesh, CatchesThresholdsOfAnotherMethod) {
  const Engine broken = [](const auto& domain, const Lattice& lattice, Method method) {
    const Method other = method == Method::angles ? Method::embedding : Method::angles;
    PlacedMesh mesh = engine(domain, lattice, other);
    mesh.method = method;
    return mesh;
  };
  EXPECT_TRUE(caught(broken));
}

}  // namespace
