/// \file
/// What every graded mesh must be: conforming by a count of its faces, of the uniform mesh's
/// volume and boundary, and of angles in the range of its theorem.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "certet/error.hpp"
#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "graded_mesh.hpp"
#include "holes.hpp"
#include "materials.hpp"
#include "seed.hpp"

namespace {

using namespace graded;
using certet::Lattice;

certet::Grading levels_of(std::int32_t levels) {
  certet::Grading grading;
  grading.levels = levels;
  return grading;
}

struct Graded {
  PlacedMesh uniform;
  std::vector<PlacedMesh> levels;  ///< by one level, by two …
  Method method;
};

Graded grade(const certet::Domain& domain, const Lattice& lattice, Method method) {
  certet::Context context;
  certet::Stuffing stuffing(domain, lattice, method, context);
  Graded graded{placed(stuffing), {}, stuffing.method()};
  for (int levels = 1; levels <= certet::most_grading_levels; ++levels) {
    stuffing.grade(levels_of(levels), context);
    EXPECT_EQ(stuffing.uniform_tet_count(), graded.uniform.tets.size());
    graded.levels.push_back(placed(stuffing));
  }
  stuffing.grade({}, context);
  EXPECT_EQ(placed(stuffing).tets, graded.uniform.tets);
  return graded;
}

void expect_sound(const Graded& graded, const std::string& what) {
  for (const PlacedMesh& mesh : graded.levels)
    EXPECT_EQ(fault(mesh, graded.uniform, range_of(graded.method)), "") << what;
}

constexpr Method methods[] = {Method::embedded, Method::angles, Method::embedding,
                              Method::midpoint, Method::key};

Lattice random_lattice(std::mt19937_64& random) {
  const auto place = [&] { return 2 * between(random, -40, 40); };
  const auto extent = [&] { return between(random, 4, 24); };
  return {{place(), place(), place()}, {extent(), extent(), extent()}};
}

TEST(Grading, OfABallIsSoundAndSmaller) {
  const Lattice lattice{{-32, -30, -34}, {33, 34, 35}};
  const Graded graded =
      grade(domains::of_level(domains::sphere(0.3, 0.2, 0.1, 27)), lattice, Method::embedded);
  expect_sound(graded, "a ball");
  EXPECT_LT(graded.levels[0].tets.size(), graded.uniform.tets.size() / 2);
  EXPECT_LT(graded.levels[1].tets.size(), graded.levels[0].tets.size());
  EXPECT_LE(graded.levels[2].tets.size(), graded.levels[1].tets.size());
}

/// A row of more than 64 cells crosses the words of a bit plane.
TEST(Grading, OfALongBarIsSound) {
  const Lattice lattice{{-130, 2, 6}, {150, 14, 13}};
  expect_sound(grade(domains::of_level([](double x, double y, double z) {
                       return std::max({std::abs(x - 20) - 145, std::abs(y - 15) - 11,
                                        std::abs(z - 18) - 10, 1 - std::hypot(x + 3, y - 14)});
                     }),
                     lattice, Method::embedded),
               "a bar");
}

TEST(Grading, OfRandomDomainsIsSound) {
  for (int trial = 0; trial < 16; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), static_cast<std::uint64_t>(trial)));
    const Lattice lattice = random_lattice(random);
    // Cells of all sizes meet in any way.
    const domains::Positional domain =
        domains::with_holes(random, lattice, between(random, 0, 5), 4);
    expect_sound(grade(domain, lattice, methods[trial % std::size(methods)]), "trial " + std::to_string(trial));
  }
}

/// Balls of several materials, which lie in each other and touch.
materials::Positional of_materials(std::mt19937_64& random, const Lattice& lattice) {
  std::vector<std::pair<domains::Level, certet::Material>> balls;
  for (int n = 0; n < 4; ++n) {
    const auto at = [&](std::int32_t from, std::int32_t cells) {
      return from + std::uniform_real_distribution(0.0, 2.0 * cells)(random);
    };
    balls.push_back({domains::sphere(at(lattice.origin.x, lattice.cells[0]),
                                     at(lattice.origin.y, lattice.cells[1]),
                                     at(lattice.origin.z, lattice.cells[2]),
                                     std::uniform_real_distribution(3.0, 14.0)(random)),
                     between(random, 0, 3)});
  }
  return {{11, 12, 13}, [balls](Coord3 p) -> certet::Material {
            constexpr double unit = certet::steps;
            certet::Material material = 2;
            for (const auto& [ball, inside] : balls)
              if (ball(p.x / unit, p.y / unit, p.z / unit) < 0) material = inside;
            return material;
          }};
}

TEST(Grading, OfSeveralMaterialsIsSound) {
  for (int trial = 0; trial < 8; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 100 + static_cast<std::uint64_t>(trial)));
    const Lattice lattice = random_lattice(random);
    const Method method = trial % 2 == 0 ? Method::embedded : Method::midpoint;
    const Graded graded = grade(of_materials(random, lattice), lattice, method);
    expect_sound(graded, "trial " + std::to_string(trial));
    for (const PlacedMesh& mesh : graded.levels)
      EXPECT_EQ(volumes(mesh), volumes(graded.uniform)) << "trial " << trial;
  }
}

/// A method that gives each tetrahedron the label at its centre has none to hold on to.
TEST(Grading, OfMaterialsWithoutInterfacesIsRefused) {
  certet::Context context;
  std::mt19937_64 random(1);
  const Lattice lattice{{0, 0, 0}, {12, 12, 12}};
  const materials::Positional domain = of_materials(random, lattice);
  certet::Stuffing stuffing(domain, lattice, Method::angles, context);
  EXPECT_THROW(stuffing.grade(levels_of(1), context), certet::Error);
}

/// Where fewer levels are asked for, no tetrahedron is larger than these give, and elsewhere
/// some are.
TEST(Grading, KeepsToTheSizesThatAreAskedFor) {
  const Lattice lattice{{-30, -26, -28}, {30, 27, 28}};
  const domains::Positional domain = domains::of_level(domains::sphere(0.3, 0.2, 0.1, 25));
  const auto most = [](double x) { return x < -8 ? 0 : x < 0 ? 1 : x < 8 ? 2 : 3; };
  certet::Context context;
  certet::Stuffing stuffing(domain, lattice, Method::embedded, context);
  const PlacedMesh uniform = placed(stuffing);
  stuffing.grade(levels_of(3), context);
  const std::uint64_t all = stuffing.tet_count();
  stuffing.grade({.levels = 3, .of_materials = {},
                  .at_points = [&](std::span<const Coord3> points, std::span<std::int32_t> levels) {
                    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = most(points[i].x);
                  }},
                 context);
  const PlacedMesh graded = placed(stuffing);
  EXPECT_EQ(fault(graded, uniform, range_of(Method::embedded)), "");
  EXPECT_GT(graded.tets.size(), all);
  EXPECT_LT(graded.tets.size(), uniform.tets.size());
  bool larger = false;
  for (const PlacedTet& tet : graded.tets) {
    double greatest = -1e9;
    for (const Coord3 p : tet.corners) greatest = std::max(greatest, double(p.x) / certet::steps);
    // A pyramid's base is as wide as the cell that it lies in; nearest the surface edges move.
    EXPECT_LE(longest_edge(tet), 1.5 * (1 << most(greatest)));
    larger = larger || longest_edge(tet) > 1.5;
  }
  EXPECT_TRUE(larger);
}

TEST(Grading, KeepsToTheLevelsOfMaterials) {
  const Lattice lattice{{-30, -26, -28}, {30, 27, 28}};
  const materials::Positional domain({5, 6}, [](Coord3 p) -> certet::Material {
    const double x = double(p.x) / certet::steps, y = double(p.y) / certet::steps,
                 z = double(p.z) / certet::steps;
    return std::hypot(x, y, z) > 25 ? 0 : x < 0.3 ? 1 : 2;
  });
  certet::Context context;
  certet::Stuffing stuffing(domain, lattice, Method::embedded, context);
  const PlacedMesh uniform = placed(stuffing);
  stuffing.grade({.levels = 3, .of_materials = {0, 2}, .at_points = {}}, context);
  const PlacedMesh graded = placed(stuffing);
  EXPECT_EQ(fault(graded, uniform, range_of(Method::embedded)), "");
  std::map<std::int32_t, double> longest;
  for (const PlacedTet& tet : graded.tets)
    longest[tet.label] = std::max(longest[tet.label], longest_edge(tet));
  EXPECT_LT(longest[5], 1.8);
  EXPECT_GT(longest[6], 3.9);
  EXPECT_LT(longest[6], 6);
}

/// The triangles of a mesh whose three vertices are on its surface, but for those with two
/// tetrahedra behind them, in an order of their own: its boundary.
std::vector<Triangle> boundary(const certet::Stuffing& stuffing, exact::Wide& volume) {
  certet::Context context;
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  std::vector<std::uint8_t> surface(mesh.points.size());
  stuffing.mark_surface(0, stuffing.layers(), surface, context);
  std::vector<Triangle> faces;
  volume = 0;
  for (const auto& tet : std::get<certet::Buffer<certet::Tet<std::uint32_t>>>(mesh.tets)) {
    std::array<Coord3, 4> corners;
    for (std::size_t n = 0; n < 4; ++n) corners[n] = mesh.points[tet[n]];
    volume += exact::six_volume(corners);
    using Face = std::array<std::size_t, 3>;
    for (const auto& [a, b, c] : {Face{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}})
      if (surface[tet[a]] && surface[tet[b]] && surface[tet[c]])
        faces.push_back(turned({corners[a], corners[b], corners[c]}));
  }
  std::ranges::sort(faces);
  std::vector<Triangle> single;
  for (const Triangle& face : faces)
    if (!std::ranges::binary_search(faces, other_side(face))) single.push_back(face);
  return single;
}

/// Of a torus of so many long edges to its greater radius.
void compare_surfaces(double radius) {
  const auto wide = static_cast<std::int32_t>(1.4 * radius) + 2;
  const auto high = static_cast<std::int32_t>(0.4 * radius) + 2;
  const domains::Positional torus =
      domains::of_level(domains::torus(0, 0, 0, 2 * radius, 0.8 * radius));
  certet::Context context;
  certet::Stuffing stuffing(torus, {{-2 * wide, -2 * wide, -2 * high}, {2 * wide, 2 * wide, 2 * high}},
                            Method::embedded, context);
  exact::Wide before = 0, after = 0;
  const std::vector<Triangle> uniform = boundary(stuffing, before);
  const std::uint64_t tets = stuffing.tet_count();
  stuffing.grade(levels_of(3), context);
  EXPECT_EQ(boundary(stuffing, after), uniform);
  EXPECT_EQ(after, before);
  EXPECT_GT(uniform.size(), 1000U);
  std::cout << tets << " tetrahedra of one size, " << stuffing.tet_count() << " graded, "
            << uniform.size() << " triangles\n";
}

TEST(Grading, KeepsTheSurfaceOfATorusTriangleByTriangle) { compare_surfaces(1 / 0.05); }

/// The same at ten million tetrahedra, some seconds of an optimised build.
TEST(Grading, KeepsTheSurfaceOfTenMillionTetrahedra) {
#ifdef NDEBUG
  compare_surfaces(1 / 0.01548);
#else
  GTEST_SKIP() << "not optimised";
#endif
}

TEST(Grading, OfNoiseIsTheUniformMesh) {
  const Graded graded =
      grade(domains::noise(test_seed(), 20), {{0, 0, 0}, {9, 9, 9}}, Method::angles);
  for (const PlacedMesh& mesh : graded.levels) EXPECT_EQ(mesh.tets, graded.uniform.tets);
}

/// A graded mesh where a planted defect is to be seen.
const Graded& sound() {
  static const Graded graded =
      grade(domains::of_level(domains::sphere(0.3, 0.2, 0.1, 15)), {{-18, -18, -18}, {19, 19, 19}},
            Method::embedded);
  return graded;
}

bool is_noticed(const std::function<void(PlacedMesh&)>& spoil) {
  PlacedMesh mesh = sound().levels[1];
  spoil(mesh);
  return !fault(mesh, sound().uniform, range_of(Method::embedded)).empty();
}

TEST(Grading, NoticesATetrahedronThatIsMissing) {
  EXPECT_TRUE(is_noticed([](PlacedMesh& m) { m.tets.pop_back(); }));
}

TEST(Grading, NoticesATetrahedronTwice) {
  EXPECT_TRUE(is_noticed([](PlacedMesh& m) { m.tets.push_back(m.tets.back()); }));
}

/// Two tetrahedra of equal size beside each other, cut along the other diagonal of a square.
TEST(Grading, NoticesAFlippedDiagonal) {
  EXPECT_TRUE(is_noticed([](PlacedMesh& m) {
    std::map<Triangle, std::size_t> faces;
    for (std::size_t t = 0; t < m.tets.size(); ++t) {
      const auto& [a, b, c, d] = m.tets[t].corners;
      for (const Triangle& face : {Triangle{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}})
        faces[turned(face)] = t;
    }
    // The halves of a pyramid: their apex in common, and the other corners in one plane.
    for (const auto& entry : faces) {
      const Triangle face = entry.first;
      const auto found = faces.find(other_side(face));
      if (found == faces.end()) continue;
      auto& one = m.tets[entry.second].corners;
      auto& two = m.tets[found->second].corners;
      const auto lone = [&](const std::array<Coord3, 4>& tet) {
        return *std::ranges::find_if(tet, [&](Coord3 p) {
          return std::ranges::find(face, p) == face.end();
        });
      };
      const Coord3 p = lone(one), q = lone(two);
      for (const Coord3 apex : face) {
        Triangle base = face;
        std::rotate(base.begin(), std::ranges::find(base, apex), base.end());
        const auto& [top, r, s] = base;
        if (p + q != r + s) continue;
        one = {p, q, r, top};
        two = {q, p, s, top};
        for (auto* tet : {&one, &two})
          if (exact::six_volume(*tet) < 0) std::swap((*tet)[0], (*tet)[1]);
        return;
      }
    }
    ADD_FAILURE() << "there is no pyramid";
  }));
}

TEST(Grading, OfTooManyLevelsIsRefused) {
  certet::Context context;
  const domains::Positional ball = domains::of_level(domains::sphere(0, 0, 0, 3));
  certet::Stuffing stuffing(ball, {{-6, -6, -6}, {7, 7, 7}}, Method::embedded, context);
  EXPECT_THROW(stuffing.grade(levels_of(certet::most_grading_levels + 1), context), certet::Error);
  EXPECT_THROW(stuffing.grade(levels_of(-1), context), certet::Error);
}

}  // namespace
