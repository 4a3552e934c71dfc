/// \file
/// Where violated vertices settle, the mesh has the shape of the samples: as many pieces,
/// tunnels and cavities, a surface that is a manifold, and angles as proved.

#include <gtest/gtest.h>

#include <algorithm>

#include "settling_fields.hpp"

namespace {

using namespace settling;
using settling::Tets;

/// How many fields of a kind a rule gets wrong.
int wrong_meshes(const Rule& rule, const std::string& how) {
  return wrong_meshes(fields(test_seed(), 20), small, rule, how);
}

/// Each of them exactly as the model says, and without a fault.
TEST(Settling, KeepsTheShapeOfRandomFields) {
  std::uint64_t stayed = 0;
  std::uint64_t shortened = 0;
  for (int batch = 0; batch < 5; ++batch)
    for (const Positional& field : fields(mixed(test_seed(), batch), 25)) {
      Model model(field, small, {});
      WarpFigures figures;
      const Tets made = engine_mesh(field, small, Method::embedded, figures);
      ASSERT_EQ(difference(model, made, figures), "");
      ASSERT_EQ(fault(model, made), "");
      stayed += figures.stayed;
      shortened += figures.shortened;
    }
  EXPECT_GT(stayed, 5000u);
  EXPECT_GT(shortened, 100u);
}

/// Where no sample is inside there is no mesh, and one is enough for it.
TEST(Settling, ALoneSampleMakesAMesh) {
  for (const std::int32_t cut : {0, 1, 9000, 26111, 40000, 65535}) {
    const auto domain = Positional([cut](Coord3 p) {
      return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= cut ? Sign::plus : Sign::minus;
    });
    WarpFigures figures;
    Model model(domain, small, {});
    const Tets made = engine_mesh(domain, small, Method::embedded, figures);
    EXPECT_EQ(fault(model, made), "");
    EXPECT_EQ(topology::of_mesh(made), (topology::Shape{1, 0, 0}));
  }
}

/// Walls halfway between lattice planes, as those of voxels are.
TEST(Settling, AWallHalfwayIsFlat) {
  const auto domain = domains::of_level(domains::box(-2.5, 2.5));
  Model model(domain, small, {});
  Tets mesh = model.mesh();
  EXPECT_EQ(fault(model, mesh), "");
  WarpFigures figures;
  EXPECT_EQ(positions(engine_mesh(domain, small, Method::embedded, figures)), positions(mesh));
  const std::int32_t wall = 5 * steps / 2;
  for (const Coord3 p : mesh.points)
    for (const std::int32_t c : {p.x, p.y, p.z}) EXPECT_LE(std::abs(c), wall);
}

// What is forgotten shows.

TEST(Settling, CatchesAClampThatIsForgotten) {
  EXPECT_GT(wrong_meshes({.clamp = false}, "an angle is out of range"), 0);
}

TEST(Settling, CatchesAMoveThatIsNotShortened) {
  EXPECT_GT(wrong_meshes({.shorten = false}, "a tetrahedron of the lattice is turned over"), 0);
}

TEST(Settling, CatchesAClosedDiskForAStrictOne) {
  const Rule rule{.may_move = settling::is_closed_disk};
  EXPECT_GT(wrong_meshes(rule, "an edge of the surface is not in two triangles") +
                wrong_meshes(rule, "the shape is another"),
            0);
}

TEST(Settling, CatchesVerticesThatAlwaysMove) {
  const Rule rule{.may_move = [](const settling::LinkSigns&) { return true; }};
  EXPECT_GT(wrong_meshes(rule, "an edge of the surface is not in two triangles"), 0);
}

}  // namespace
