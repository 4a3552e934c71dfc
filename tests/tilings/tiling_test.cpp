/// \file
/// The engine on another tiling with other stencils: its own sources, compiled with
/// kuhn/lattice/tiling_in_use.hpp in the place of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "certet/function_domain.hpp"
#include "certet/stuffing.hpp"
#include "lattice/tiling_in_use.hpp"
#include "seed.hpp"
#include "tiling_defects.hpp"

namespace {

using namespace certet;

using PlacedTet = std::array<Coord3, 4>;

/// A random solid, smooth, that the border of the lattice cuts off.
struct Waves {
  explicit Waves(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (double& number : numbers) number = std::uniform_real_distribution<double>(-1, 1)(random);
  }
  double operator()(const Point3& p) const {
    double value = 0.3 * numbers[0];
    for (std::size_t n = 0; n < 4; ++n)
      value += std::sin(0.6 * (numbers[4 * n + 1] * p[0] + numbers[4 * n + 2] * p[1] +
                               numbers[4 * n + 3] * p[2]) + 3 * numbers[4 * n + 4]);
    return value;
  }
  std::array<double, 17> numbers{};
};

/// The mesh as the tiling and the stencils say, cell by cell, without the engine.
template <class AnyTiling>
std::vector<PlacedTet> straightforward(const AnyTiling& tiling,
                                       const std::array<Stencil, pattern_count>& stencils,
                                       const Waves& inside, const Lattice& lattice) {
  const auto sign_at = [&](Coord3 p) {
    const Coord3 d = p - lattice.origin;
    const std::array<std::int32_t, 3> index{d.x >> 1, d.y >> 1, d.z >> 1};
    for (std::size_t a = 0; a < 3; ++a)
      if (index[a] < 1 || index[a] > lattice.cells[a] - 2) return Sign::minus;
    return inside(Frame{}.world(steps * p)) <= 0 ? Sign::plus : Sign::minus;
  };
  std::vector<PlacedTet> mesh;
  for (int k = 0; k < lattice.cells[2]; ++k)
    for (int j = 0; j < lattice.cells[1]; ++j)
      for (int i = 0; i < lattice.cells[0]; ++i)
        for (const StructuredTetShape& tet : tiling.tets) {
          std::array<Coord3, 4> v = tet.vertices;
          CornerSigns signs{};
          for (std::size_t n = 0; n < 4; ++n) {
            v[n] = lattice.origin + 2 * Coord3{i, j, k} + v[n];
            signs[n] = sign_at(v[n]);
          }
          for (const UnstructuredTet& made : stencils[static_cast<std::size_t>(pattern_index(signs))]) {
            PlacedTet placed;
            for (std::size_t n = 0; n < 4; ++n) placed[n] = steps / 2 * (v[made[n].a] + v[made[n].b]);
            if (!tet.right_handed) std::swap(placed[2], placed[3]);
            mesh.push_back(placed);
          }
        }
  std::ranges::sort(mesh);
  return mesh;
}

std::vector<PlacedTet> engine(const Waves& inside, const Lattice& lattice) {
  Context context;
  context.threads = 1;
  const FunctionDomain domain(inside, Frame{});
  const Mesh mesh = stuff(domain, lattice, {}, Method::midpoint, context);
  std::vector<PlacedTet> placed;
  std::visit([&](const auto& tets) {
    for (const auto& tet : tets) {
      PlacedTet& p = placed.emplace_back();
      for (std::size_t n = 0; n < 4; ++n) p[n] = mesh.points[tet[n]];
    }
  }, mesh.tets);
  std::ranges::sort(placed);
  return placed;
}

/// Faces that are neither of two tetrahedra nor of one and on the surface.  Cuts lie
/// between lattice points, which are even.
int open_faces(const std::vector<PlacedTet>& mesh) {
  std::map<std::array<Coord3, 3>, int> faces;
  for (const PlacedTet& tet : mesh)
    for (std::size_t across = 0; across < 4; ++across) {
      std::array<Coord3, 3> face{};
      for (std::size_t n = 0; n < 3; ++n) face[n] = tet[n < across ? n : n + 1];
      std::ranges::sort(face);
      ++faces[face];
    }
  const auto is_cut = [](Coord3 p) { return ((p.x | p.y | p.z) & (2 * steps - 1)) != 0; };
  return static_cast<int>(std::ranges::count_if(faces, [&](const auto& face) {
    return face.second > 2 || (face.second == 1 && !std::ranges::all_of(face.first, is_cut));
  }));
}

constexpr Lattice lattice{{-10, -12, -8}, {70, 11, 9}};

class OtherTiling : public testing::TestWithParam<int> {
 protected:
  Waves inside{mixed(test_seed(), GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Solids, OtherTiling, testing::Range(0, 6));

TEST_P(OtherTiling, IsWhatTheEngineMeshes) {
  const auto mesh = engine(inside, lattice);
  EXPECT_GT(mesh.size(), 100U);
  EXPECT_TRUE(mesh == straightforward(core::tiling, core::stencils, inside, lattice));
}

TEST_P(OtherTiling, IsClosedAndPositive) {
  const auto mesh = engine(inside, lattice);
  for (const PlacedTet& t : mesh) EXPECT_GT(six_volume(t[0], t[1], t[2], t[3]), 0);
  EXPECT_EQ(open_faces(mesh), 0);
}

TEST_P(OtherTiling, WantsOtherStencils) {
  EXPECT_GT(open_faces(straightforward(core::tiling, stencil_table, inside, lattice)), 0);
}

TEST(Tilings, HaveNoDefect) {
  EXPECT_EQ(tilings::defects(lattice_tiling), std::set<std::string>{});
  EXPECT_EQ(tilings::defects(core::tiling), std::set<std::string>{});
}

TEST(Tilings, EveryPlantedDefectIsFound) {
  const auto& tiling = tilings::kuhn_tiling;
  for (std::size_t c = 0; c < tiling.tets.size(); ++c) {
    const auto found = [&](const char* what, auto plant) {
      auto planted = tiling;
      plant(planted.tets[c]);
      EXPECT_TRUE(tilings::defects(planted).contains(what)) << what << " of case " << c;
    };
    found("hand", [](auto& tet) { tet.right_handed = !tet.right_handed; });
    for (std::size_t i = 0; i < 4; ++i) {
      found("neighbour", [&](auto& tet) { tet.vertices[i].x += 2; });
      found("neighbour", [&](auto& tet) { std::swap(tet.neighbors[i].order[0], tet.neighbors[i].order[1]); });
      found("neighbour", [&](auto& tet) { tet.neighbors[i].id.anchor.y += 2; });
      found("neighbour of the neighbour", [&](auto& tet) { tet.neighbors[i].id.anchor.z += 4; });
    }
  }
  auto lost = tilings::kuhn_tiling;
  lost.edges[6] = lost.edges[5];
  EXPECT_TRUE(tilings::defects(lost).contains("edge"));
  lost = tilings::kuhn_tiling;
  lost.directions[13] = lost.directions[12];
  EXPECT_TRUE(tilings::defects(lost).contains("direction"));
}

}  // namespace
