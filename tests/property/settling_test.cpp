/// \file
/// Where violated vertices settle, the mesh has the shape of the samples: as many pieces,
/// tunnels and cavities, a surface that is a manifold, and angles as proved.

#include <gtest/gtest.h>

#include <algorithm>

#include "exact.hpp"
#include "settling_model.hpp"
#include "topology.hpp"

namespace {

using namespace certet;
using domains::Positional;
using settling::Model;
using settling::Rule;
using settling::Tets;

Tets engine_mesh(const Positional& domain, const Lattice& lattice, WarpFigures& figures) {
  Context context;
  context.threads = 1;
  const Stuffing stuffing(domain, lattice, {}, context);
  figures = stuffing.warp_figures();
  return settling::tets_of(emit(stuffing, {}, context));
}

std::string angle_fault(const Tets& mesh) {
  for (const auto& [a, b, c, d] : mesh.tets) {
    const exact::Tet tet{mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
    if (exact::six_volume(tet) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(tet))
      if (!exact::angles_range.contains(angle)) return "an angle is out of range";
  }
  return "";
}

/// The first thing that is wrong with a mesh of a model's samples.
std::string fault(const Model& model, const Tets& mesh) {
  if (!model.is_unfolded()) return "a tetrahedron of the lattice is turned over";
  std::string what = angle_fault(mesh);
  if (what.empty()) what = topology::surface_fault(mesh);
  if (!what.empty()) return what;
  const topology::Shape samples = topology::of_samples(model);
  if (topology::of_mesh(mesh) != samples) return "the shape is another";
  if (topology::pieces_by_faces(mesh) != samples.pieces) return "a piece hangs by less than a face";
  return "";
}

/// The corners of every tetrahedron, those of least coordinates first.
std::vector<exact::Tet> positions(const Tets& mesh) {
  std::vector<exact::Tet> placed;
  for (const auto& [a, b, c, d] : mesh.tets) {
    placed.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    std::ranges::sort(placed.back());
  }
  std::ranges::sort(placed);
  return placed;
}

constexpr Lattice small{{-6, -8, -4}, {7, 8, 7}};

/// A number that depends on the seed and on the key.
double real(std::uint64_t seed, int key, double low, double high) {
  return low + (high - low) * static_cast<double>(mixed(seed, key) >> 11) * 0x1p-53;
}

/// A sum of three waves, along the axes.
domains::Level waves(std::uint64_t seed) {
  std::array<double, 3> frequency;
  std::array<double, 3> phase;
  for (int a = 0; a < 3; ++a) {
    frequency[static_cast<std::size_t>(a)] = real(seed, a, .3, 1.4);
    phase[static_cast<std::size_t>(a)] = real(seed, 3 + a, 0, 6);
  }
  const double level = real(seed, 6, -1.5, 1.5);
  return [=](double x, double y, double z) {
    return std::sin(frequency[0] * x + phase[0]) + std::sin(frequency[1] * y + phase[1]) +
           std::sin(frequency[2] * z + phase[2]) - level;
  };
}

/// Small boxes whose walls are near the quarters of edges, as those of voxels are.
domains::Level boxes(std::uint64_t seed) {
  return [=](double x, double y, double z) {
    const auto cell = [](double c) { return static_cast<int>(std::floor((c - 0.5) / 2)); };
    const std::uint64_t h = mixed(seed, cell(x), cell(y), cell(z));
    return h % 3 == 0 ? -1.0 : 1.0;
  };
}

/// A wall across long edges near their quarters, rough: neighbours that move onto it from
/// either side move past each other.
domains::Level rough_wall(std::uint64_t seed) {
  return [=](double x, double y, double z) {
    const auto nearest = [](double c) { return static_cast<int>(std::lround(c)); };
    const double rough = real(mixed(seed, nearest(y), nearest(z)), 0, -.065, .065);
    return std::max(x - .5 - rough, -4.5 - x);
  };
}

/// Fields of several kinds, so many of each: noise cut anywhere, at the thresholds, with
/// samples on the surface or near the quarters; waves, thin sheets, boxes, and rough walls.
std::vector<Positional> fields(std::uint64_t seed, int each) {
  std::vector<Positional> all;
  for (int n = 0; n < each; ++n) {
    const std::uint64_t own = mixed(seed, n);
    all.push_back(domains::random_cuts(own, 0, {0, 3000, 9000, 17000, 30000, 42000, 60000, 65535}));
    all.push_back(domains::random_cuts(own, 0, {0, 1, 18687, 18688, 26111, 26112, 39424, 46848, 65535}));
    all.push_back(domains::random_cuts(own, 60, {10, 20000, 32768, 50000}));
    all.push_back(domains::random_cuts(own, 0, {16384, 16385, 17000, 18687}));
    all.push_back(domains::of_level(boxes(mixed(own, 2))));
    all.push_back(domains::of_level(rough_wall(mixed(own, 3))));
    all.push_back(domains::of_level(waves(mixed(own, 1))));
    all.push_back(domains::of_level(
        domains::slab(real(own, 1, -1, 1), real(own, 2, -1, 1), real(own, 3, .1, 1),
                      real(own, 4, -1, 1), real(own, 5, .2, 3))));
  }
  return all;
}

/// How many fields of a kind a rule gets wrong.
int wrong_meshes(const Rule& rule, const std::string& how) {
  int wrong = 0;
  for (const Positional& field : fields(test_seed(), 20)) {
    Model model(field, small, rule);
    wrong += fault(model, model.mesh()) == how;
  }
  return wrong;
}

/// Each of them exactly as the model says, and without a fault.
TEST(Settling, KeepsTheShapeOfRandomFields) {
  std::uint64_t stayed = 0;
  std::uint64_t shortened = 0;
  for (int batch = 0; batch < 5; ++batch)
    for (const Positional& field : fields(mixed(test_seed(), batch), 25)) {
      Model model(field, small, {});
      const Tets expected = model.mesh();
      WarpFigures figures;
      const Tets made = engine_mesh(field, small, figures);
      ASSERT_EQ(figures, model.figures());
      ASSERT_EQ(positions(made), positions(expected));
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
    const Tets made = engine_mesh(domain, small, figures);
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
  EXPECT_EQ(positions(engine_mesh(domain, small, figures)), positions(mesh));
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
