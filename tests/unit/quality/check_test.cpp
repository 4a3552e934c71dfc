/// Each rule of `check`, by a mesh that breaks it.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "certet/check.hpp"
#include "certet/stuffing.hpp"
#include "mesh/faces.hpp"
#include "domains.hpp"

namespace certet {
namespace {

using Tet32 = Tet<std::uint32_t>;
using Tet64 = Tet<std::uint64_t>;

struct Block {
  std::vector<Point3> points;
  std::vector<Tet32> tets;

  [[nodiscard]] CheckReport report() const { return check(points, std::span<const Tet32>(tets)); }
};

/// n³ cubes, each cut in six tetrahedra around a diagonal.
Block block(std::uint32_t n) {
  Block block;
  const std::uint32_t m = n + 1;
  for (std::uint32_t k = 0; k < m; ++k)
    for (std::uint32_t j = 0; j < m; ++j)
      for (std::uint32_t i = 0; i < m; ++i)
        block.points.push_back({double{1} * i, double{1} * j, double{1} * k});
  const std::uint32_t step[3] = {1, m, m * m};
  constexpr int around[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (std::uint32_t i = 0; i < n * n * n; ++i) {
    const std::uint32_t corner = i % n + i / n % n * m + i / n / n * m * m;
    for (const auto& [a, b, c] : around) {
      const std::uint32_t p = corner + step[a], q = p + step[b], r = q + step[c];
      const bool even = (b - a + 3) % 3 == 1;
      block.tets.push_back(even ? Tet32{corner, p, q, r} : Tet32{corner, q, p, r});
    }
  }
  return block;
}

TEST(Check, AGoodMeshPasses) {
  const CheckReport report = block(4).report();
  EXPECT_TRUE(report.failures.empty()) << report.failures.front();
  EXPECT_EQ(report.points, 125u);
  EXPECT_EQ(report.quality.tets, 6u * 64);
  EXPECT_NEAR(report.quality.volume, 64, 1e-12);
  EXPECT_EQ(report.boundary_faces, 6u * 16 * 2);
}

TEST(Check, NoTetrahedraAreNoMesh) {
  EXPECT_EQ(Block{}.report().failures.size(), 1u);
}

TEST(Check, BadIndices) {
  Block mesh = block(2);
  mesh.tets[7][2] = static_cast<std::uint32_t>(mesh.points.size());
  mesh.tets[9][0] = mesh.tets[9][3];
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.bad_indices, 2u);
  EXPECT_EQ(report.quality.tets, 46u);
  ASSERT_FALSE(report.failures.empty());
  EXPECT_NE(report.failures[0].find("number 7"), std::string::npos) << report.failures[0];
}

TEST(Check, PointsThatNoTetrahedronUses) {
  Block mesh = block(2);
  mesh.points.push_back({9, 9, 9});
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.unused_points, 1u);
  ASSERT_EQ(report.failures.size(), 1u);
  EXPECT_EQ(report.failures[0], "1 point is in no tetrahedron, the first being number 27");
}

TEST(Check, PointsThatAreNotFinite) {
  Block mesh = block(2);
  mesh.points[13][1] = std::numeric_limits<double>::quiet_NaN();
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.nonfinite_points, 1u);
  EXPECT_GT(report.quality.nonpositive, 0u);
  EXPECT_EQ(report.failures.size(), 2u);
}

/// Two halves side by side that do not share the points between them.
TEST(Check, ACrackShowsByItsDoublePoints) {
  Block mesh = block(1);
  const Block other = block(1);
  for (const Point3& p : other.points) mesh.points.push_back({p[0] + 1, p[1], -0.0 + p[2]});
  for (const Tet32& t : other.tets) mesh.tets.push_back({t[0] + 8, t[1] + 8, t[2] + 8, t[3] + 8});
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.duplicate_points, 4u);
  EXPECT_EQ(report.failures.size(), 1u);
  // The two zeros are one place.
  mesh = block(1);
  mesh.points.push_back({-0.0, 0.0, -0.0});
  EXPECT_EQ(mesh.report().duplicate_points, 1u);
}

TEST(Check, AHoleShowsByItsBoundary) {
  Block mesh = block(3);
  // All edges of the middle cube are inside, and so are its tetrahedra's faces.
  const std::size_t middle = 6 * 13;
  mesh.tets.erase(mesh.tets.begin() + middle, mesh.tets.begin() + middle + 6);
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.boundary_faces, 6u * 9 * 2 + 12);
  EXPECT_NEAR(report.quality.volume, 26, 1e-12);
  EXPECT_TRUE(report.failures.empty());
}

TEST(Check, ADoubledTetrahedron) {
  Block mesh = block(1);
  mesh.tets = {mesh.tets[0]};
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets[0] = {0, 1, 2, 3};
  EXPECT_TRUE(mesh.report().failures.empty());
  mesh.tets.push_back({1, 2, 0, 3});
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.misoriented_faces, 4u);
  EXPECT_EQ(report.boundary_faces, 0u);
  ASSERT_EQ(report.failures.size(), 1u);
  EXPECT_NE(report.failures[0].find("4 inner faces"), std::string::npos);
}

TEST(Check, ATetrahedronOnAFaceThatHasTwo) {
  Block mesh = block(2);
  EXPECT_EQ(mesh.report().overfull_faces, 0u);
  // A face inside the first cube, seen from a point far away.
  const Tet32 tet = mesh.tets[0];
  mesh.points.push_back({-1, 5, 2});
  mesh.tets.push_back({tet[0], tet[1], tet[3], 27});
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.overfull_faces, 1u);
  EXPECT_EQ(report.open_edges, 3u);
  EXPECT_FALSE(report.failures.empty());
}

TEST(Check, AnInvertedTetrahedron) {
  Block mesh = block(3);
  std::swap(mesh.tets[6 * 13][0], mesh.tets[6 * 13][1]);
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.quality.nonpositive, 1u);
  EXPECT_EQ(report.misoriented_faces, 4u);
  EXPECT_EQ(report.failures.size(), 2u);
}

TEST(Check, AnInvertedTetrahedronAtTheBoundaryLeavesEdgesOpen) {
  Block mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
             {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  const CheckReport report = mesh.report();
  EXPECT_EQ(report.quality.nonpositive, 1u);
  EXPECT_EQ(report.misoriented_faces, 1u);
  EXPECT_EQ(report.open_edges, 3u);
  std::swap(mesh.tets[1][0], mesh.tets[1][1]);
  EXPECT_TRUE(mesh.report().failures.empty());
}

TEST(Check, IndicesOfBothWidthsGiveTheSame) {
  Block mesh = block(3);
  std::swap(mesh.tets[5][0], mesh.tets[5][1]);
  mesh.tets.push_back(mesh.tets[40]);
  std::vector<Tet64> wide;
  for (const Tet32& t : mesh.tets) wide.push_back({t[0], t[1], t[2], t[3]});
  const CheckReport a = mesh.report();
  const CheckReport b = check(mesh.points, std::span<const Tet64>(wide));
  EXPECT_EQ(a.failures, b.failures);
  EXPECT_EQ(a.boundary_faces, b.boundary_faces);
  EXPECT_EQ(a.misoriented_faces, b.misoriented_faces);
}

TEST(Check, MeshesOfTheEnginePass) {
  Context context;
  const Lattice lattice{{-24, -24, -24}, {24, 24, 24}};
  for (const Method method : {Method::angles, Method::embedding}) {
    const auto torus = domains::of_level(domains::torus(0, 0, 0, 14, 6));
    const Mesh mesh = stuff(torus, lattice, {}, method, context);
    std::vector<Point3> points;
    for (const Coord3 p : mesh.points) points.push_back(mesh.frame.world(p));
    const std::span<const Tet32> tets = std::get<Buffer<Tet32>>(mesh.tets);
    const CheckReport report = check(points, tets);
    EXPECT_TRUE(report.failures.empty()) << report.failures.front();
    const AngleBounds& bounds = facts(method).bounds;
    EXPECT_GE(report.quality.min_dihedral, bounds.min_dihedral);
    EXPECT_LE(report.quality.max_dihedral, bounds.max_dihedral);
    const Quality exact = measure_lattice(mesh.points, 0, tets);
    EXPECT_NEAR(exact.volume, report.quality.volume, 1e-9 * exact.volume);
    EXPECT_NEAR(exact.min_dihedral, report.quality.min_dihedral, 1e-9);
    EXPECT_NEAR(exact.max_dihedral, report.quality.max_dihedral, 1e-9);
  }
}

TEST(Faces, WideKeysFindWhatNarrowOnesFind) {
  Block mesh = block(3);
  std::swap(mesh.tets[5][0], mesh.tets[5][1]);
  mesh.tets.push_back({mesh.tets[40][0], mesh.tets[40][1], mesh.tets[40][3], 0});
  const std::span<const Tet32> tets(mesh.tets);
  const auto all = [](std::size_t) { return true; };
  Context context;
  const auto narrow = core::find_faces<core::NarrowFace>(mesh.points.size(), tets, all, context);
  const auto wide = core::find_faces<core::WideFace>(mesh.points.size(), tets, all, context);
  EXPECT_GT(narrow.misoriented, 0u);
  EXPECT_EQ(narrow.misoriented, wide.misoriented);
  EXPECT_EQ(narrow.overfull, wide.overfull);
  ASSERT_EQ(narrow.boundary.size(), wide.boundary.size());
  for (std::size_t i = 0; i < narrow.boundary.size(); ++i) {
    EXPECT_EQ(narrow.boundary[i].points, wide.boundary[i].points);
    EXPECT_EQ(narrow.boundary[i].reversed, wide.boundary[i].reversed);
  }
}

TEST(Faces, KeysHoldTheGreatestPoints) {
  constexpr std::uint64_t last = core::NarrowFace::point_limit - 1;
  for (const bool reversed : {false, true}) {
    const core::Face face = core::NarrowFace(last - 1, last, reversed).face(last - 2);
    EXPECT_EQ(face.points, (std::array<std::uint64_t, 3>{last - 2, last - 1, last}));
    EXPECT_EQ(face.reversed, reversed);
  }
}

TEST(Faces, ASurfaceWithAMissingOrATurnedTriangleIsOpen) {
  std::vector<core::Face> surface = {
      {{0, 1, 2}, true}, {{0, 1, 3}, false}, {{0, 2, 3}, true}, {{1, 2, 3}, false}};
  Context context;
  EXPECT_EQ(core::find_edges(4, surface, context).open, 0u);
  surface[1].reversed = true;
  EXPECT_EQ(core::find_edges(4, surface, context).open, 3u);
  surface.erase(surface.begin() + 1);
  EXPECT_EQ(core::find_edges(4, surface, context).open, 3u);
}

}  // namespace
}  // namespace certet
