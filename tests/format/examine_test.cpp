// Regions and interfaces: looked at in a mesh, and in what a file holds of them.

#include "certet/examine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "certet/count_pieces.hpp"
#include "sample_mesh.hpp"
#include "scratch_folder.hpp"

namespace certet {
namespace {

using test::cubes;
using test::SampleMesh;
using test::ScratchFolder;

constexpr std::uint32_t side = 4;
const double dx = std::sqrt(2), dy = std::sqrt(3), dz = std::sqrt(5);

Examination examined(const SampleMesh& mesh, int threads = 0) {
  Context context;
  context.threads = threads;
  return examine(mesh.points, std::span<const Tet<std::uint32_t>>(mesh.tets), mesh.labels, context);
}

/// Left, right, and a cube on the border of both.
SampleMesh three_regions() {
  return cubes(side, [](auto i, auto j, auto k) { return i == 1 && j == 1 && k == 1 ? 9 : i < 2 ? 4 : 5; });
}

bool has(const std::vector<std::string>& failures, const std::string& words) {
  return std::ranges::any_of(failures, [&](const auto& f) { return f.find(words) != f.npos; });
}

TEST(Examine, MeasuresRegionsAndInterfaces) {
  const Examination found = examined(three_regions());
  EXPECT_TRUE(found.report.failures.empty()) << found.report.failures.front();
  ASSERT_EQ(found.regions.size(), 3u);
  const RegionReport& cube = found.regions[2];
  EXPECT_EQ(cube.label, 9);
  EXPECT_EQ(cube.quality.tets, 6u);
  EXPECT_EQ(cube.faces, 12u);
  EXPECT_NEAR(cube.quality.volume, dx * dy * dz, 1e-12);
  EXPECT_NEAR(cube.area, 2 * (dx * dy + dy * dz + dz * dx), 1e-12);
  EXPECT_EQ(cube.pieces, (PieceCount{1, 1}));
  ASSERT_EQ(found.interfaces.size(), 3u);
  const auto& [left_right, left_cube, right_cube] =
      std::tie(found.interfaces[0], found.interfaces[1], found.interfaces[2]);
  EXPECT_EQ(left_right.labels, (std::array{4, 5}));
  EXPECT_EQ(left_right.triangles, 2u * (side * side - 1));
  EXPECT_NEAR(left_right.area, (side * side - 1) * dy * dz, 1e-12);
  EXPECT_EQ(left_right.border_edges, 4u * side + 4);
  EXPECT_EQ(left_cube.triangles, 10u);
  EXPECT_EQ(left_cube.border_edges, 4u);
  EXPECT_EQ(right_cube.triangles, 2u);
  for (const InterfaceReport& interface : found.interfaces) {
    EXPECT_EQ(interface.loose_edges, 0u);
    EXPECT_EQ(interface.nonmanifold, ManifoldFaults{});
  }
}

TEST(Examine, AgreesWithWhatItIsMadeOf) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    SampleMesh mesh = cubes(side, [&](auto, auto, auto) { return static_cast<int>(random() % 5) - 1; });
    if (round % 3 == 1) mesh.labels.clear();
    if (round % 4 == 2)  // Something missing, and something twice.
      for (int n = 0; n < 30; ++n) mesh.tets[random() % mesh.tets.size()] = mesh.tets[random() % mesh.tets.size()];
    if (round % 5 == 3) mesh.tets[5][2] = 1'000'000;
    Context context;
    const std::span<const Tet<std::uint32_t>> tets = mesh.tets;
    const Examination found = examined(mesh, round % 3);
    EXPECT_EQ(found.pieces, count_pieces(mesh.points, tets, mesh.labels, context));
    const CheckReport report = check(mesh.points, tets, context);
    EXPECT_EQ(found.report.overfull_faces, report.overfull_faces);
    EXPECT_EQ(found.report.misoriented_faces, report.misoriented_faces);
    EXPECT_EQ(found.report.open_edges, report.open_edges);
    EXPECT_EQ(found.report.boundary_faces, report.boundary_faces);
    EXPECT_EQ(found.report.quality.histogram, report.quality.histogram);
    EXPECT_GE(found.report.failures.size(), report.failures.size());
    for (std::size_t n = 0; n < report.failures.size(); ++n)
      EXPECT_EQ(found.report.failures[n], report.failures[n]);
    const Survey known = survey(mesh.points.size(), mesh.wide_tets(), mesh.labels, context);
    EXPECT_EQ(found.survey.boundary, known.boundary);
    if (report.overfull_faces == 0) {
      EXPECT_EQ(found.survey.interfaces, known.interfaces);
    }
  }
}

TEST(Examine, FindsARegionThatIsNotClosed) {
  SampleMesh mesh = three_regions();
  const auto of_cube = std::ranges::find(mesh.labels, 9) - mesh.labels.begin();
  std::swap(mesh.tets[static_cast<std::size_t>(of_cube)][0],
            mesh.tets[static_cast<std::size_t>(of_cube)][1]);
  const Examination found = examined(mesh);
  EXPECT_TRUE(has(found.report.failures, "the surface of region 9 is not closed and oriented at"));
  EXPECT_GT(found.regions[2].open_edges, 0u);
}

TEST(Examine, FindsAnInterfaceThatEndsInMidAir) {
  SampleMesh mesh = three_regions();
  // A tetrahedron twice takes its faces away, one of which is in the middle of an interface.
  const Examination whole = examined(mesh);
  const auto& faces = whole.survey.interfaces[0].faces;
  const auto inner = std::ranges::find_if(faces, [&](const BoundaryFace& face) {
    return std::ranges::all_of(face.points, [&](std::uint64_t p) {
      return mesh.points[p][1] > 2.5 * dy && mesh.points[p][1] < 3.5 * dy + 1e-9 &&
             mesh.points[p][2] > 1.5 * dz && mesh.points[p][2] < 3.5 * dz;
    }) || (mesh.points[face.points[0]][1] > 0.5 * dy && mesh.points[face.points[0]][2] > 2.5 * dz &&
           mesh.points[face.points[1]][2] < 3.5 * dz);
  });
  ASSERT_NE(inner, faces.end());
  mesh.tets.push_back(mesh.tets[inner->tet]);
  mesh.labels.push_back(mesh.labels[inner->tet]);
  const Examination found = examined(mesh);
  EXPECT_GT(found.interfaces[0].loose_edges, 0u);
  EXPECT_TRUE(has(found.report.failures, "the interface of the regions 4 and 5 ends at"));
}

TEST(Examine, TellsWhereAnInterfaceIsNoManifold) {
  // Two cubes of one label that touch in an edge, within another.
  const SampleMesh mesh = cubes(side, [](auto i, auto j, auto k) {
    return (i == 1 && j == 1 && k == 1) || (i == 2 && j == 2 && k == 1) ? 2 : 1;
  });
  const Examination found = examined(mesh);
  EXPECT_TRUE(found.report.failures.empty());
  ASSERT_EQ(found.interfaces.size(), 1u);
  EXPECT_EQ(found.interfaces[0].nonmanifold, (ManifoldFaults{1, 2}));
  EXPECT_EQ(found.interfaces[0].border_edges, 0u);
  EXPECT_EQ(found.regions[1].nonmanifold, (ManifoldFaults{1, 2}));
  EXPECT_EQ(found.regions[1].pieces, (PieceCount{2, 1}));
}

/// What a file holds of the surfaces of three regions, and what is wrong with it.
class HeldSurfaces : public testing::TestWithParam<std::pair<Format, const char*>> {
 protected:
  void SetUp() override {
    test::write_as(file(), GetParam().first, mesh_);
    read_ = certet::read(file());
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / GetParam().second; }
  [[nodiscard]] std::vector<std::string> failures() const {
    Context context;
    return compare_surfaces(read_, survey(read_, context)).failures;
  }
  /// The surface between two labels; they are the third to the fifth.
  std::vector<std::array<std::uint64_t, 3>>& between(std::size_t place) {
    return read_.surfaces.at(read_.surfaces.size() - 3 + place).faces;
  }
  SampleMesh mesh_ = three_regions();
  FileMesh read_;
  ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Formats, HeldSurfaces,
                         testing::Values(std::pair(Format::gmsh, "a.msh"),
                                         std::pair(Format::gmsh22, "b.msh"),
                                         std::pair(Format::medit, "a.mesh"),
                                         std::pair(Format::medit_binary, "a.meshb")),
                         [](const auto& info) {
                           std::string format(name(info.param.first));
                           return format;
                         });

TEST_P(HeldSurfaces, AreThoseOfTheMesh) {
  EXPECT_EQ(failures(), std::vector<std::string>{});
  Context context;
  const SurfaceComparison found = compare_surfaces(read_, survey(read_, context));
  ASSERT_EQ(found.surfaces.size(), 4u);
  EXPECT_EQ(found.surfaces[0].outer, 12u * side * side);
  EXPECT_EQ(found.surfaces[1].interface, (std::array{4, 5}));
  EXPECT_EQ(found.surfaces[1].between, found.surfaces[1].triangles);
}

TEST_P(HeldSurfaces, MayLackATriangle) {
  between(0).pop_back();
  EXPECT_TRUE(has(failures(), "lacks 1 of the 30 triangles between the regions 4 and 5"));
  EXPECT_EQ(failures().size(), 1u);
}

TEST_P(HeldSurfaces, MayHaveATriangleOfAnotherPair) {
  between(0).push_back(between(1).back());
  between(1).pop_back();
  EXPECT_TRUE(has(failures(), "has 1 triangle elsewhere than between the regions 4 and 5"));
  EXPECT_TRUE(has(failures(), "lacks 1 of the 10 triangles between the regions 4 and 9"));
}

TEST_P(HeldSurfaces, MayBeOfTheWrongPair) {
  std::swap(between(1), between(2));
  EXPECT_EQ(failures().size(), 4u);
}

TEST_P(HeldSurfaces, MayHaveATriangleTwiceOrNowhere) {
  between(1).push_back(between(1).front());
  EXPECT_TRUE(has(failures(), "has 1 triangle twice"));
  between(1).back() = {0, 1, 1'000'000};
  EXPECT_TRUE(has(failures(), "has 1 triangle elsewhere than between the regions 4 and 9"));
}

TEST_P(HeldSurfaces, MayBeMissing) {
  read_.surfaces.pop_back();
  EXPECT_TRUE(has(failures(), "the file has no surface between the regions 5 and 9"));
}

TEST_P(HeldSurfaces, OfOthersAreOnlyToldOf) {
  // One surface of all that there is, under a name or number of its own.
  FileSurface all{77, "everything"};
  if (read_.surfaces[0].name.empty()) all.name.clear();
  for (const FileSurface& surface : read_.surfaces)
    all.faces.insert(all.faces.end(), surface.faces.begin(), surface.faces.end());
  read_.surfaces = {all};
  EXPECT_EQ(failures(), std::vector<std::string>{});
}

}  // namespace
}  // namespace certet
