/// \file
/// The program certet-reference, from its command line to its file, against the
/// engine.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "certet/formats.hpp"
#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "materials.hpp"

namespace {

namespace fs = std::filesystem;
using certet::Coord3;
using certet::Lattice;
using certet::Point3;
using certet::Sign;

using PlacedTets = std::vector<std::array<Point3, 4>>;

class ReferenceProgram : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  /// The exit status.
  int run(const std::string& arguments) {
    const std::string command =
        CERTET_REFERENCE " " + arguments + " 2>" + (folder / "errors").string();
    const int status = std::system(command.c_str());
    return WEXITSTATUS(status);
  }

  PlacedTets reference(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " " + output.string()), 0);
    const certet::FileMesh mesh = certet::read(output);
    PlacedTets placed;
    for (const auto& [a, b, c, d] : mesh.tets)
      placed.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    return placed;
  }

  fs::path folder = fs::path(testing::TempDir()) /
                    testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path output = folder / "out.mesh";
};

/// In lattice units, in which the program writes.
PlacedTets engine(const certet::Domain& domain, const Lattice& lattice,
                  certet::Method method = certet::Method::angles, int levels = 0) {
  certet::Frame units;
  units.size = 2;
  certet::Context context;
  certet::Stuffing stuffing(domain, lattice, method, context);
  certet::Grading grading;
  grading.levels = levels;
  stuffing.grade(grading, context);
  const certet::Mesh mesh = certet::emit(stuffing, units, context);
  PlacedTets placed;
  const auto world = [&](auto i) { return units.world(mesh.points[i]); };
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets)
          placed.push_back({world(a), world(b), world(c), world(d)});
      },
      mesh.tets);
  return placed;
}

TEST_F(ReferenceProgram, MeshesASphere) {
  const PlacedTets theirs = reference(
      "--guarantee angles --solid 'sphere 7.1 7.2 6.9 5.3' --lattice '0 0 0 8 9 8'");
  EXPECT_GT(theirs.size(), 500U);
  const Lattice lattice{{0, 0, 0}, {8, 9, 8}};
  const auto ball = [](double r) { return domains::of_level(domains::sphere(7.1, 7.2, 6.9, r)); };
  EXPECT_TRUE(engine(ball(5.3), lattice) == theirs);
  EXPECT_FALSE(engine(ball(5.3001), lattice) == theirs);
}

/// A thin torus, of which some vertices stay.
TEST_F(ReferenceProgram, KeepsTheShapeByDefault) {
  const Lattice lattice{{-8, -8, -8}, {9, 9, 9}};
  const auto thin = domains::of_level(domains::torus(0.3, 0.2, 0.1, 4.1, 1.2));
  const PlacedTets kept = reference("--solid 'torus 0.3 0.2 0.1 4.1 1.2' --lattice '-8 -8 -8 9 9 9'");
  EXPECT_GT(kept.size(), 100U);
  EXPECT_TRUE(engine(thin, lattice, certet::Method::embedded) == kept);
  EXPECT_FALSE(engine(thin, lattice, certet::Method::angles) == kept);
}

TEST_F(ReferenceProgram, HasDiagonalsThatFollowTheCuts) {
  const Lattice lattice{{-8, -8, -8}, {9, 9, 9}};
  const auto torus = domains::of_level(domains::torus(0.3, 0.2, 0.1, 4.1, 2.2));
  const PlacedTets theirs =
      reference("--guarantee key --solid 'torus 0.3 0.2 0.1 4.1 2.2' --lattice '-8 -8 -8 9 9 9'");
  EXPECT_GT(theirs.size(), 100U);
  EXPECT_TRUE(engine(torus, lattice, certet::Method::key) == theirs);
  EXPECT_FALSE(engine(torus, lattice, certet::Method::embedded) == theirs);
}

TEST_F(ReferenceProgram, MeshesATorusForAnEmbedding) {
  EXPECT_TRUE(engine(domains::of_level(domains::torus(0.5, 0.25, 0.125, 5.5, 2.25)),
                     {{-10, -10, -6}, {11, 11, 7}},
                     certet::Method::embedding) ==
              reference("--guarantee embedding --solid 'torus 0.5 0.25 0.125 5.5 2.25' "
                        "--lattice '-10 -10 -6 11 11 7'"));
}

TEST_F(ReferenceProgram, MeshesABoxWithMidpoints) {
  EXPECT_TRUE(engine(domains::of_level(domains::box(-4.5, 4.5)), {{-8, -8, -8}, {9, 9, 9}},
                     certet::Method::midpoint) ==
              reference("--midpoint --solid 'box -4.5 -4.5 -4.5 4.5 4.5 4.5' "
                        "--lattice '-8 -8 -8 9 9 9'"));
}

/// The cut of an edge from its + end, found by bisection.
std::int32_t cut_of(const domains::Positional& domain, Coord3 plus, Coord3 direction) {
  std::int32_t low = 0;
  for (std::int32_t half = certet::steps / 2; half > 0; half /= 2) {
    const Sign sign = domain.sign_at(certet::steps * plus + (low + half) * direction);
    if (sign != Sign::minus) low += half;
    if (sign == Sign::on_surface) break;
  }
  return low;
}

void write_signs(const fs::path& file, const domains::Positional& domain,
                 const Lattice& lattice) {
  const auto& [o, cells] = lattice;
  const auto sign = [&](Coord3 v) { return domain.sign_at(certet::steps * v); };
  std::ofstream out(file);
  out << "certet-signs\nlattice " << o.x << ' ' << o.y << ' ' << o.z << ' ' << cells[0] << ' '
      << cells[1] << ' ' << cells[2] << '\n';
  std::vector<Coord3> inside;
  for (const std::int32_t shift : {0, 1}) {
    out << (shift == 0 ? "even\n" : "odd\n");
    for (int k = 0; k < cells[2]; ++k)
      for (int j = 0; j < cells[1]; ++j, out << '\n')
        for (int i = 0; i < cells[0]; ++i) {
          const Coord3 v = o + 2 * Coord3{i, j, k} + shift * Coord3{1, 1, 1};
          if (sign(v) == Sign::plus) inside.push_back(v);
          out << "-0+"[static_cast<int>(sign(v))];
        }
  }
  out << "cuts\n";
  for (const Coord3 v : inside)
    for (const Coord3 d : certet::direction_offset)
      out << v.x << ' ' << v.y << ' ' << v.z << "  " << v.x + d.x << ' ' << v.y + d.y << ' '
          << v.z + d.z << "  " << cut_of(domain, v, d) << '\n';
}

TEST_F(ReferenceProgram, MeshesASampledDomain) {
  constexpr Lattice lattice{{2, 4, -6}, {6, 5, 7}};
  const domains::Positional domain =
      domains::random_cuts(5, 30, {10000, 20000, 33333, 50000, 60000});
  write_signs(folder / "noise.signs", domain, lattice);
  const PlacedTets theirs =
      reference("--guarantee angles --signs " + (folder / "noise.signs").string());
  EXPECT_GT(theirs.size(), 50U);
  EXPECT_TRUE(engine(domain, lattice) == theirs);
}

/// Random materials, the lattice's outermost points outside; every edge is cut in its middle,
/// where the program puts cuts that it is not told of.
materials::Positional halved(const Lattice& lattice, std::uint64_t seed) {
  const auto material = [=](Coord3 v) -> certet::Material {
    const Coord3 d = v - lattice.origin;
    const auto [nx, ny, nz] = lattice.cells;
    const auto inner = [](std::int32_t c, std::int32_t cells) { return c >= 2 && c / 2 < cells - 1; };
    if (!inner(d.x, nx) || !inner(d.y, ny) || !inner(d.z, nz)) return 0;
    return static_cast<certet::Material>(mixed(seed, v.x, v.y, v.z) % 4);
  };
  return {{1, 2, 3}, [=](Coord3 p) {
            const auto [a, b, t] = domains::edge_of(p);
            const certet::Material near = material(a);
            if (t == 0) return near;
            const certet::Material far = material(b);
            const bool at_near = near > far ? 2 * t <= certet::steps : 2 * t < certet::steps;
            return at_near ? near : far;
          }};
}

void write_materials(const fs::path& file, const materials::Positional& domain,
                     const Lattice& lattice) {
  const auto& [o, cells] = lattice;
  std::ofstream out(file);
  out << "certet-materials\nlattice " << o.x << ' ' << o.y << ' ' << o.z << ' ' << cells[0] << ' '
      << cells[1] << ' ' << cells[2] << '\n';
  for (const std::int32_t shift : {0, 1}) {
    out << (shift == 0 ? "even\n" : "odd\n");
    for (int k = 0; k < cells[2]; ++k)
      for (int j = 0; j < cells[1]; ++j, out << '\n')
        for (int i = 0; i < cells[0]; ++i)
          out << domain.material_at(certet::steps *
                                    (o + 2 * Coord3{i, j, k} + shift * Coord3{1, 1, 1}))
              << ' ';
  }
}

TEST_F(ReferenceProgram, MeshesSeveralMaterials) {
  constexpr Lattice lattice{{2, 4, -6}, {6, 5, 7}};
  const auto domain = halved(lattice, 7);
  write_materials(folder / "three.materials", domain, lattice);
  const std::string given = "--materials " + (folder / "three.materials").string();
  for (const certet::Method method : {certet::Method::embedded, certet::Method::midpoint}) {
    const bool midpoint = method == certet::Method::midpoint;
    EXPECT_TRUE(engine(domain, lattice, method) == reference(midpoint ? given + " --midpoint" : given));
    certet::Context context;
    const certet::Mesh mesh = certet::stuff(domain, lattice, {}, method, context);
    EXPECT_TRUE(std::ranges::equal(mesh.labels, certet::read(output).labels));
  }
}

/// Which tetrahedra come first is each one's own affair.
PlacedTets sorted(PlacedTets tets) {
  std::ranges::sort(tets);
  return tets;
}

TEST_F(ReferenceProgram, GradesABall) {
  const Lattice lattice{{-12, -12, -10}, {13, 12, 12}};
  const auto ball = domains::of_level(domains::sphere(0.3, 0.2, 0.1, 9.3));
  const std::string given = "--solid 'sphere 0.3 0.2 0.1 9.3' --lattice '-12 -12 -10 13 12 12'";
  for (const int levels : {1, 2}) {
    const PlacedTets theirs = reference(given + " --grade " + std::to_string(levels));
    EXPECT_TRUE(sorted(engine(ball, lattice, certet::Method::embedded, levels)) == sorted(theirs));
    EXPECT_FALSE(sorted(engine(ball, lattice, certet::Method::embedded)) == sorted(theirs));
  }
  EXPECT_TRUE(sorted(engine(ball, lattice, certet::Method::midpoint, 2)) ==
              sorted(reference(given + " --midpoint --grade 2")));
}

TEST_F(ReferenceProgram, GradesSeveralMaterials) {
  constexpr Lattice lattice{{2, 4, -6}, {13, 12, 11}};
  const materials::Positional halves({1, 2}, [=](Coord3 p) -> certet::Material {
    const Coord3 d = p - certet::steps * lattice.origin;
    const auto inner = [](std::int32_t c, std::int32_t cells) {
      return c > certet::steps && c < (2 * cells - 3) * certet::steps;
    };
    if (!inner(d.x, 13) || !inner(d.y, 12) || !inner(d.z, 11)) return 0;
    return d.x < 12 * certet::steps ? 1 : 2;
  });
  write_materials(folder / "two.materials", halves, lattice);
  const PlacedTets theirs =
      reference("--materials " + (folder / "two.materials").string() + " --midpoint --grade 2");
  EXPECT_TRUE(sorted(engine(halves, lattice, certet::Method::midpoint, 2)) == sorted(theirs));
  EXPECT_LT(theirs.size(), engine(halves, lattice, certet::Method::midpoint).size());
}

TEST_F(ReferenceProgram, SaysWhatIsWrong) {
  const auto expect = [&](const std::string& arguments, int status, const std::string& words) {
    EXPECT_EQ(run(arguments), status) << arguments;
    std::ifstream errors(folder / "errors");
    std::string line, more;
    std::getline(errors, line);
    EXPECT_EQ(line, std::string("certet-reference: ").append(words));
    EXPECT_FALSE(std::getline(errors, more)) << more;
    EXPECT_FALSE(fs::exists(output));
  };
  const std::string out = std::string(" ").append(output.string());
  expect("--solid 'sphere 1 2' --lattice '0 0 0 3 3 3'" + out, 2,
         "'sphere 1 2' is no solid that is known");
  expect("--lattice '1 0 0 3 3 3' --solid 'sphere 0 0 0 1'" + out, 2,
         "'1 0 0 3 3 3' is no lattice: three even numbers and three more");
  expect("--sphere" + out, 2, "unknown option '--sphere'.");
  expect(out, 2, "give --signs, --materials, or --solid and --lattice");
  expect("--solid 'sphere 90 0 0 1' --lattice '0 0 0 3 3 3'" + out, 1,
         "nothing is inside: there is no mesh to make");
  expect("--grade 4 --solid 'sphere 0 0 0 1' --lattice '0 0 0 3 3 3'" + out, 2,
         "--grade takes 0 to 3 levels");
  expect("--signs /nowhere/a" + out, 1, "/nowhere/a: No such file or directory");
}

}  // namespace
