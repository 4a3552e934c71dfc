/// \file
/// Meshes of several materials: they fill what they share, every interface is the same
/// from both sides, angles are as proved, and each material keeps its pieces.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "certet/lattice/material_stencil.hpp"
#include "certet/lattice/well_shaped.hpp"
#include "certet/stuffing.hpp"
#include "disjoint_sets.hpp"
#include "domains.hpp"
#include "exact.hpp"
#include "materials.hpp"
#include "whole_mesh.hpp"

namespace {

using namespace certet;
using Triangle = std::array<std::uint32_t, 3>;

std::span<const Tet<std::uint32_t>> tets_of(const Mesh& mesh) {
  return std::get<Buffer<Tet<std::uint32_t>>>(mesh.tets);
}

/// Every face with the tetrahedra that have it.
std::map<Triangle, std::vector<std::size_t>> faces_of(const Mesh& mesh) {
  std::map<Triangle, std::vector<std::size_t>> faces;
  const auto tets = tets_of(mesh);
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (std::size_t apex = 0; apex < 4; ++apex) {
      Triangle face;
      for (std::size_t n = 0; n < 3; ++n) face[n] = tets[t][(apex + 1 + n) % 4];
      std::ranges::sort(face);
      faces[face].push_back(t);
    }
  return faces;
}

/// How many pieces each label has, hanging together by faces.
std::map<std::int32_t, int> pieces_of(const Mesh& mesh) {
  DisjointSets sets(mesh.tet_count());
  for (const auto& [face, tets] : faces_of(mesh))
    if (tets.size() == 2 && mesh.labels[tets[0]] == mesh.labels[tets[1]])
      sets.join(tets[0], tets[1]);
  std::map<std::int32_t, int> pieces;
  for (std::size_t t = 0; t < mesh.tet_count(); ++t)
    if (sets.root(t) == t) ++pieces[mesh.labels[t]];
  return pieces;
}

std::string shape_fault(const Mesh& mesh) {
  const exact::AngleRange& range =
      mesh.method == Method::midpoint ? exact::midpoint_range : exact::angles_range;
  std::set<std::uint32_t> used;
  for (const auto& tet : tets_of(mesh)) {
    used.insert(tet.begin(), tet.end());
    const exact::Tet corners{mesh.points[tet[0]], mesh.points[tet[1]], mesh.points[tet[2]],
                             mesh.points[tet[3]]};
    if (exact::six_volume(corners) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(corners))
      if (!range.contains(angle)) return "an angle is out of range";
  }
  return used.size() == mesh.points.size() ? "" : "a point belongs to no tetrahedron";
}

/// Faces are shared by two at most, and the surface of each label, and of all of them, has
/// an even number of its triangles at every edge: two, as far as `manifold` asks.
std::string surface_fault(const Mesh& mesh, bool manifold) {
  std::map<std::int32_t, std::map<std::array<std::uint32_t, 2>, int>> edges;
  const auto add = [&](std::int32_t label, const Triangle& face) {
    for (std::size_t n = 0; n < 3; ++n) {
      const auto [a, b] = std::minmax(face[n], face[(n + 1) % 3]);
      ++edges[label][{a, b}];
    }
  };
  for (const auto& [face, tets] : faces_of(mesh)) {
    if (tets.size() > 2) return "three tetrahedra share a face";
    if (tets.size() == 1) add(-1, face);
    if (tets.size() == 2 && mesh.labels[tets[0]] == mesh.labels[tets[1]]) continue;
    for (const std::size_t t : tets) add(mesh.labels[t], face);
  }
  for (const auto& [label, counts] : edges)
    for (const auto& [edge, count] : counts) {
      if (count % 2 != 0) return "the surface of " + std::to_string(label) + " is open";
      if (manifold && count != 2)
        return "an edge of the surface of " + std::to_string(label) + " is in " +
               std::to_string(count) + " triangles";
    }
  return "";
}

Lattice small_lattice() { return {{-2, 0, 4}, {9, 8, 9}}; }

/// Cubes of random materials, some of them outside, at walls anywhere between vertices.
materials::Positional random_cubes(std::uint64_t seed, int side) {
  const auto cubes = materials::cubes(seed, side, {1, 2, 3, 7}, static_cast<unsigned>(seed % 3 * 50));
  const auto moved = static_cast<std::int32_t>(seed % 9) * (steps / 8);
  return {{1, 2, 3, 7}, [=](Coord3 p) { return cubes.material_at(p + Coord3{moved, 2 * moved, moved / 3}); }};
}

/// Cells around random points: smooth walls, junctions of three and of four.
materials::Positional random_cells(std::uint64_t seed, int count) {
  std::vector<std::array<double, 3>> centres;
  for (int n = 0; n < count; ++n)
    centres.push_back({static_cast<double>(mixed(seed, n, 0, 0) % 1000) / 62 - 2,
                       static_cast<double>(mixed(seed, n, 1, 0) % 1000) / 62,
                       static_cast<double>(mixed(seed, n, 2, 0) % 1000) / 62 + 4});
  std::vector<std::int32_t> labels(static_cast<std::size_t>(count) - 1);
  std::iota(labels.begin(), labels.end(), 1);
  return {labels, [=](Coord3 p) {
            constexpr double unit = 1.0 / steps;
            std::size_t best = 0;
            double least = 1e300;
            for (std::size_t n = 0; n < centres.size(); ++n) {
              const double x = unit * p.x - centres[n][0];
              const double y = unit * p.y - centres[n][1];
              const double z = unit * p.z - centres[n][2];
              const double distance = x * x + y * y + z * z;
              if (distance < least) {
                least = distance;
                best = n;
              }
            }
            return static_cast<Material>(best);
          }};
}

template <class MakeDomain>
void expect_good_meshes(const MakeDomain& domain_of, std::uint64_t seeds) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const auto domain = domain_of(seed);
    const Mesh middle = whole_mesh(domain, small_lattice(), Method::midpoint);
    const Mesh mesh = whole_mesh(domain, small_lattice(), Method::embedded);
    ASSERT_EQ(shape_fault(middle), "") << seed;
    ASSERT_EQ(shape_fault(mesh), "") << seed;
    ASSERT_EQ(surface_fault(middle, true), "") << seed;
    ASSERT_EQ(surface_fault(mesh, true), "") << seed;
    // With cuts in the middle no vertex moves: the pieces are those of the samples.
    ASSERT_EQ(pieces_of(mesh), pieces_of(middle)) << seed;
  }
}

TEST(Interfaces, OfRandomCubes) {
  expect_good_meshes([](std::uint64_t seed) { return random_cubes(seed, 3); }, 15);
}
TEST(Interfaces, OfNoise) {
  expect_good_meshes([](std::uint64_t seed) { return random_cubes(seed, 1); }, 12);
}
TEST(Interfaces, OfCells) {
  expect_good_meshes([](std::uint64_t seed) { return random_cells(seed, 7); }, 15);
}

/// `MaterialReduces`, of whole meshes: where only one of the materials occurs, the mesh is
/// that of the solid, point by point.
TEST(Interfaces, OneMaterialIsTheSolid) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto solid = domains::random_cuts(seed, 0, {100, 7000, 15000, 24000, 40000, 65000});
    const Material only = 1 + static_cast<Material>(seed % 3);
    const materials::Positional one{{4, 5, 6}, [&](Coord3 p) {
                                      return solid.sign_at(p) == Sign::plus ? only : 0;
                                    }};
    for (const Method method : {Method::embedded, Method::midpoint}) {
      const Mesh expected = whole_mesh(solid, small_lattice(), method);
      const Mesh mesh = whole_mesh(one, small_lattice(), method);
      ASSERT_TRUE(std::ranges::equal(mesh.points, expected.points)) << seed;
      ASSERT_TRUE(std::ranges::equal(tets_of(mesh), tets_of(expected))) << seed;
      ASSERT_TRUE(std::ranges::all_of(mesh.labels, [&](int label) { return label == 3 + only; }));
    }
  }
}

/// A wall halfway between two planes of lattice points, towards which all that is beside it
/// moves until it is level.  Four of these make a flat tetrahedron.  Against the outside it is
/// dropped; between two materials it would be kept, so that the last of the four stays:
/// `MayShare` of the certificate, which looks at its shape, is needed.
TEST(Interfaces, NoFourCornersComeLevelBetweenTwoMaterials) {
  const Lattice lattice{{0, 0, 0}, {12, 12, 13}};
  const auto wall = [](Material below, std::int32_t twice_z) {
    std::vector<std::int32_t> labels(static_cast<std::size_t>(below) + 1);
    std::iota(labels.begin(), labels.end(), 1);
    return materials::Positional{labels, [=](Coord3 p) {
                                   return 2 * p.z < twice_z * steps ? below : below + 1;
                                 }};
  };
  const auto stayed = [&](const Domain& domain) {
    Context context;
    return Stuffing(domain, lattice, Method::embedded, context).warp_figures().stayed;
  };
  constexpr std::uint64_t half_the_odd = 8 * 8 / 2;  // beside the wall, and not near its rim
  EXPECT_EQ(stayed(wall(0, 25)), 0U);
  EXPECT_GT(stayed(wall(1, 25)), stayed(wall(1, 26)) + half_the_odd);
  const auto halves = wall(1, 25);
  const Mesh mesh = whole_mesh(halves, lattice, Method::embedded);
  EXPECT_EQ(shape_fault(mesh), "");
  EXPECT_EQ(surface_fault(mesh, true), "");
}

TEST(Interfaces, AreTheSameForEveryThreadCount) {
  const auto domain = random_cells(5, 9);
  const Mesh expected = whole_mesh(domain, small_lattice(), Method::embedded, 1);
  for (const int threads : {2, 3, 8}) {
    const Mesh mesh = whole_mesh(domain, small_lattice(), Method::embedded, threads);
    EXPECT_TRUE(std::ranges::equal(mesh.points, expected.points));
    EXPECT_TRUE(std::ranges::equal(tets_of(mesh), tets_of(expected)));
    EXPECT_TRUE(std::ranges::equal(mesh.labels, expected.labels));
  }
}

/// All the space of some cells is filled: what they do not have has the cell outside.
TEST(Interfaces, TheVolumesAreThoseOfTheCells) {
  const Lattice lattice{{0, 0, 0}, {34, 34, 34}};
  const materials::Positional halves{{1, 2}, [](Coord3 p) {
    const auto inside = [](std::int32_t c) { return c > 7 * steps && c < 57 * steps; };
    if (!inside(p.x) || !inside(p.y) || !inside(p.z)) return 0;
    return p.x + p.y / 2 + p.z / 4 < 56 * steps ? 1 : 2;
  }};
  const Mesh mesh = whole_mesh(halves, lattice, Method::embedded);
  std::array<double, 3> volume{};
  const auto tets = tets_of(mesh);
  for (std::size_t t = 0; t < tets.size(); ++t)
    volume[static_cast<std::size_t>(mesh.labels[t])] += std::ldexp(
        static_cast<double>(six_volume(mesh.points[tets[t][0]], mesh.points[tets[t][1]],
                                       mesh.points[tets[t][2]], mesh.points[tets[t][3]])) / 6,
        -3 * step_bits);
  EXPECT_NEAR(volume[1] + volume[2], 50 * 50 * 50, 50 * 50 * 50 * 0.003);
  EXPECT_NEAR(volume[1] - volume[2], 0, 50 * 50 * 50 * 0.003);
}

}  // namespace
