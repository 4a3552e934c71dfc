/// \file
/// What every mesh of the engine must be, whatever the domain: right-handed,
/// conforming, closed, and of angles in the range of the theorem that covers it.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "exact.hpp"

namespace {

using certet::Coord3;
using certet::Method;
using certet::Lattice;
using domains::Positional;

using Index = std::uint64_t;

/// A mesh with plain indices.
struct PlainMesh {
  std::vector<Coord3> points;
  std::vector<std::array<Index, 4>> tets;
  Method method{};

  [[nodiscard]] exact::Tet placed(const std::array<Index, 4>& tet) const {
    return {points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]};
  }
};

PlainMesh mesh_of(const certet::Domain& domain, const Lattice& lattice,
                  Method method) {
  certet::Context context;
  const certet::Stuffing stuffing(domain, lattice, method, context);
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  PlainMesh plain;
  plain.points.assign(mesh.points.begin(), mesh.points.end());
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets) plain.tets.push_back({a, b, c, d});
      },
      mesh.tets);
  plain.method = stuffing.method();
  return plain;
}

/// The first property that a mesh breaks, in words; empty if it has them all.
std::string points_fault(const PlainMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& tet : mesh.tets)
    for (const Index i : tet) {
      if (i >= used.size()) return "an index is out of range";
      used[i] = true;
    }
  if (std::ranges::find(used, false) != used.end()) return "a point is not used";
  if (std::set(mesh.points.begin(), mesh.points.end()).size() != mesh.points.size())
    return "two points are at one place";
  return "";
}

std::string angle_fault(const PlainMesh& mesh, const exact::AngleRange& range) {
  for (const auto& tet : mesh.tets) {
    const exact::Tet placed = mesh.placed(tet);
    if (exact::six_volume(placed) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(placed))
      if (!range.contains(angle))
        return "an angle of " + std::to_string(static_cast<double>(angle.degrees())) + " degrees";
  }
  return "";
}

/// The same vertices the same way round, starting from the least.
std::array<Index, 3> turned(std::array<Index, 3> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Whether a position is a lattice point that lies inside for certain: no edge
/// is cut within its first step, so that it is not warped onto a surface at
/// distance 0 either.
bool is_inside(const Positional& domain, const Lattice& lattice, Coord3 position) {
  const Coord3 d = position - certet::steps * lattice.origin;
  if ((d.x | d.y | d.z) & (certet::steps - 1)) return false;
  const std::array<std::int32_t, 3> index{d.x / certet::steps, d.y / certet::steps,
                                          d.z / certet::steps};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((index[axis] & 1) != (index[0] & 1)) return false;
    if (index[axis] / 2 < 1 || index[axis] / 2 > lattice.cells[axis] - 2) return false;
  }
  if (domain.sign_at(position) != certet::Sign::plus) return false;
  return std::ranges::none_of(certet::direction_offset, [&](Coord3 offset) {
    return domain.sign_at(position + offset) == certet::Sign::minus;
  });
}

/// Every tetrahedron has a vertex inside, so that a crack shows as a boundary
/// face with such a vertex.
std::string boundary_fault(const PlainMesh& mesh, const Positional& domain,
                           const Lattice& lattice) {
  std::set<std::array<Index, 3>> faces;
  for (const auto& [a, b, c, d] : mesh.tets)
    for (const auto& face : {std::array{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}})
      if (!faces.insert(turned(face)).second) return "two tetrahedra are on one side of a face";
  std::map<Coord3, bool> known;
  const auto inside = [&](Coord3 p) {
    const auto [entry, is_new] = known.try_emplace(p);
    if (is_new) entry->second = is_inside(domain, lattice, p);
    return entry->second;
  };
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [a, b, c] : faces) {
    if (faces.contains(turned({a, c, b}))) continue;
    for (const Index i : {a, b, c})
      if (inside(mesh.points[i])) return "there is a crack";
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[edge];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) return "the boundary is not closed";
  }
  return "";
}

std::string fault(const PlainMesh& mesh, const Positional& domain, const Lattice& lattice) {
  const exact::AngleRange& range = mesh.method == Method::embedding ? exact::embedding_range
                                   : mesh.method == Method::key     ? exact::key_range
                                                                    : exact::angles_range;
  std::string what = points_fault(mesh);
  if (what.empty()) what = angle_fault(mesh, range);
  if (what.empty()) what = boundary_fault(mesh, domain, lattice);
  return what;
}

double volume(const PlainMesh& mesh) {
  exact::Wide sum = 0;
  for (const auto& tet : mesh.tets) sum += exact::six_volume(mesh.placed(tet));
  constexpr double unit = certet::steps;
  return static_cast<double>(sum) / (6 * unit * unit * unit);
}

constexpr Lattice whole{{-18, -18, -18}, {19, 19, 19}};
constexpr Method warping_methods[] = {Method::embedded, Method::angles, Method::embedding,
                                      Method::key};

void expect_sound(const Positional& domain) {
  for (const Method method : warping_methods) {
    const PlainMesh mesh = mesh_of(domain, whole, method);
    EXPECT_GT(mesh.tets.size(), 50U);
    EXPECT_EQ(fault(mesh, domain, whole), "");
  }
}

TEST(MeshProperty, OfASphere) {
  const Positional sphere = domains::of_level(domains::sphere(0.31, 0.17, 0.23, 14.2));
  expect_sound(sphere);
  const double exact_volume = 4.0 / 3 * std::numbers::pi * std::pow(14.2, 3);
  EXPECT_NEAR(volume(mesh_of(sphere, whole, {})) / exact_volume, 1, 0.01);
}

TEST(MeshProperty, OfATorus) {
  expect_sound(domains::of_level(domains::torus(0.1, 0.2, 0.3, 10, 4.7)));
}

/// Thinner ones than this hold no vertex that is not warped away.
TEST(MeshProperty, OfAThinSlab) {
  expect_sound(domains::of_level(domains::slab(1, 2, 3, 0.1, 1.6)));
  expect_sound(domains::of_level(domains::slab(0, 0, 1, 0, 1.2)));
}

TEST(MeshProperty, OfAGyroid) { expect_sound(domains::of_level(domains::gyroid(11, 0.8))); }

TEST(MeshProperty, WithVerticesExactlyOnTheSurface) {
  expect_sound(domains::of_level(domains::box(-8, 8)));
  expect_sound(domains::of_level(domains::box(-9, 7)));
  expect_sound(domains::of_level(domains::sphere(0, 0, 0, 12)));
  expect_sound(domains::of_level(domains::slab(1, 1, 0, 0, 4)));
}

TEST(MeshProperty, OfADomainThatLeavesTheLattice) {
  expect_sound(Positional([](Coord3) { return certet::Sign::plus; }));
  expect_sound(domains::of_level(domains::sphere(10, 0, 0, 15)));
}

TEST(MeshProperty, OfPureNoise) {
  for (const unsigned zeros : {0U, 10U, 128U})
    expect_sound(domains::noise(test_seed(), zeros));
}

/// Every cut just inside or just outside of a threshold, or in the middle.
TEST(MeshProperty, OfCutsAtTheThresholds) {
  for (const certet::Thresholds th : {certet::angle_thresholds, certet::embedding_thresholds}) {
    std::vector<std::int32_t> cuts{certet::steps / 2};
    for (const int direction : {0, 6})
      for (const std::int32_t beside : {-1, 0}) {
        cuts.push_back(th.in_steps(direction) + beside);
        cuts.push_back(certet::steps - th.in_steps(direction) - beside);
      }
    for (const unsigned zeros : {0U, 40U})
      expect_sound(domains::random_cuts(test_seed(), zeros, cuts));
  }
}

TEST(MeshProperty, OfRandomDomains) {
  EXPECT_TRUE(rc::check("any mesh is sound", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto method = *rc::gen::elementOf(std::vector<Method>(std::begin(warping_methods), std::end(warping_methods)));
    const auto cut = rc::gen::inRange(0, certet::steps);
    const auto cuts = *rc::gen::container<std::vector<std::int32_t>>(4, cut);
    const Lattice small{{0, 0, 0}, {8, 9, 7}};
    const Positional domain = domains::random_cuts(seed, 10, cuts);
    const std::string what =
        fault(mesh_of(domain, small, method), domain, small);
    if (!what.empty()) RC_FAIL("seed " + std::to_string(seed) + ": " + what);
  }));
}

/// Cuts in the middle of each edge leave no angle below 30 degrees.  Positions
/// are whole half units then, so that the measure is exact: cot 30 squared is 3.
TEST(MeshProperty, OfMidpointsHasThirtyDegrees) {
  const Positional domain = domains::random_cuts(test_seed(), 0, {certet::steps / 2});
  const PlainMesh mesh = mesh_of(domain, whole, Method::midpoint);
  EXPECT_EQ(points_fault(mesh) + boundary_fault(mesh, domain, whole), "");
  bool attained = false;
  for (const auto& tet : mesh.tets) {
    exact::Tet placed = mesh.placed(tet);
    for (Coord3& p : placed)
      p = {p.x / (certet::steps / 2), p.y / (certet::steps / 2), p.z / (certet::steps / 2)};
    ASSERT_GT(exact::six_volume(placed), 0);
    for (const exact::Dihedral& a : exact::dihedrals(placed)) {
      const exact::Wide unit = a.volume * a.volume * a.edge_squared;
      if (a.n > 0) {
        ASSERT_LE(a.n * a.n, 3 * unit);
        attained = attained || a.n * a.n == 3 * unit;
      } else {
        ASSERT_LE(a.n * a.n, unit);  // 135 degrees
      }
    }
  }
  EXPECT_TRUE(attained);
}

/// A sound mesh, to be spoiled.
class MeshFault : public testing::Test {
 protected:
  [[nodiscard]] std::string found() const { return fault(mesh, domain, lattice); }

  Lattice lattice{{-10, -10, -10}, {11, 11, 11}};
  Positional domain = domains::of_level(domains::sphere(0.31, 0.17, 0.23, 6.2));
  PlainMesh mesh = mesh_of(domain, lattice, {});
};

TEST_F(MeshFault, NoneWithoutABug) { EXPECT_EQ(found(), ""); }

TEST_F(MeshFault, CatchesAMirroredTetrahedron) {
  std::swap(mesh.tets[7][0], mesh.tets[7][1]);
  EXPECT_EQ(found(), "a tetrahedron is not positive");
}

TEST_F(MeshFault, CatchesARepeatedTetrahedron) {
  mesh.tets.push_back(mesh.tets.front());
  EXPECT_EQ(found(), "two tetrahedra are on one side of a face");
}

TEST_F(MeshFault, CatchesAMissingTetrahedron) {
  mesh.tets.erase(mesh.tets.begin() + static_cast<std::ptrdiff_t>(mesh.tets.size() / 2));
  EXPECT_EQ(found(), "there is a crack");
}

TEST_F(MeshFault, CatchesATornVertex) {
  auto& tet = mesh.tets[mesh.tets.size() / 2];
  Coord3 beside = mesh.points[tet[1]];
  beside.x += 1;
  mesh.points.push_back(beside);
  tet[1] = mesh.points.size() - 1;
  EXPECT_EQ(found(), "there is a crack");
}

TEST_F(MeshFault, CatchesAPointTwice) {
  auto& tet = mesh.tets[mesh.tets.size() / 2];
  mesh.points.push_back(mesh.points[tet[1]]);
  tet[1] = mesh.points.size() - 1;
  EXPECT_EQ(found(), "two points are at one place");
}

TEST_F(MeshFault, CatchesAPointOutOfPlace) {
  Coord3& point = mesh.points[mesh.points.size() / 2];
  point = point + 3 * certet::steps / 2 * Coord3{1, 1, 1};
  EXPECT_NE(found(), "");
}

TEST_F(MeshFault, CatchesAnAngleOutOfRange) {
  EXPECT_EQ(angle_fault(mesh, exact::angles_range), "");
  EXPECT_NE(angle_fault(mesh, exact::AngleRange(30, 150)), "");
}

}  // namespace
