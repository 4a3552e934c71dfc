/// \file
/// What several solids answer as one domain: against the definition, point by point.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "extents.hpp"
#include "lattice/lattice_edges.hpp"
#include "materials.hpp"
#include "solids.hpp"

namespace certet {
namespace {

/// Boxes, balls and a function in one another's way; some of their faces are the same
/// planes, and some of these hold lattice points.
std::vector<NamedSolid> crowd() {
  return {{"block", solids::block({-1, -1, -1}, {1, 1, 1})},
          {"ball", solids::ball(1.1)},
          {"beside", solids::block({1, -1, -1}, {1.5, 1, 1})},
          {"shape", shape_solid("box:0.5,3,0.5")},
          {"half", function_solid([](Point3 p) { return p[0] + p[1] * p[2]; },
                                  Bounds{{-1.25, -0.75, -0.5}, {0.5, 0.75, 1.25}})}};
}

const std::vector<std::vector<std::string>>& priorities() {
  static const std::vector<std::vector<std::string>> all{
      {}, {"block"}, {"block", "ball", "beside", "shape", "half"}, {"shape", "beside"}};
  return all;
}

/// The definition: the strongest solid that has the point or touches it.  Materials are solids
/// from the weakest on.
struct Definition {
  std::vector<std::shared_ptr<const PlacedDomain>> solids;
  std::vector<Material> strongest;  ///< numbers of solids, from 1

  Definition(const std::vector<NamedSolid>& all, const PlacedDomain& domain,
             const std::vector<std::string>& priority) {
    for (const NamedSolid& one : all)
      solids.push_back(one.solid.on({domain.lattice(), domain.frame()}));
    for (const std::string& name : priority)
      for (std::size_t n = 0; n < all.size(); ++n)
        if (all[n].name == name) strongest.push_back(static_cast<Material>(n + 1));
    for (auto n = static_cast<Material>(all.size()); n > 0; --n)
      if (std::ranges::find(strongest, n) == strongest.end()) strongest.push_back(n);
  }

  [[nodiscard]] Sign sign(Material m, Coord3 p) const {
    Sign sign{};
    solids[static_cast<std::size_t>(solid(m) - 1)]->at({&p, 1}, {&sign, 1});
    return sign;
  }
  [[nodiscard]] Material solid(Material m) const {
    return strongest[strongest.size() - static_cast<std::size_t>(m)];
  }
  [[nodiscard]] Material material(Coord3 p) const {
    auto m = static_cast<Material>(strongest.size());
    while (m > 0 && sign(m, p) == Sign::minus) --m;
    return m;
  }
};

Coord3 random_position(std::mt19937_64& random, const Lattice& lattice) {
  const auto at = [&](std::int32_t from, std::int32_t cells) {
    return between(random, steps * from, steps * (from + 2 * cells));
  };
  return {at(lattice.origin.x, lattice.cells[0]), at(lattice.origin.y, lattice.cells[1]),
          at(lattice.origin.z, lattice.cells[2])};
}

/// Positions, half of them lattice points, of which the domain has another material than
/// the definition.
int differences(std::mt19937_64& random, const PlacedDomain& domain,
                const Definition& definition, std::array<int, 6>& seen) {
  int count = 0;
  for (int n = 0; n < 4000; ++n) {
    Coord3 p = random_position(random, domain.lattice());
    if (n % 2 == 0) p = steps * Coord3{p.x / steps, p.y / steps, p.z / steps};
    Material material = 0;
    domain.materials_at({&p, 1}, {&material, 1});
    count += material != definition.material(p);
    ++seen[static_cast<std::size_t>(material)];
  }
  return count;
}

TEST(MaterialsDomain, TheStrongestSolidHasThePoint) {
  std::mt19937_64 random(test_seed());
  for (const auto& priority : priorities()) {
    const auto domain = materials_domain(crowd(), {.size = 0.25}, priority);
    Definition definition(crowd(), *domain, priority);
    std::array<int, 6> seen{};
    EXPECT_EQ(differences(random, *domain, definition, seen), 0);
    for (const int count : seen) EXPECT_GT(count, 0);
    for (Material m = 1; m <= 5; ++m)
      EXPECT_EQ(domain->labels()[static_cast<std::size_t>(m - 1)], definition.solid(m));
    // A priority turned round would not go unnoticed.
    std::ranges::reverse(definition.strongest);
    EXPECT_GT(differences(random, *domain, definition, seen), 100);
  }
}

TEST(MaterialsDomain, RowsBlocksAndSignsAgree) {
  std::mt19937_64 random(test_seed());
  int decided = 0;
  for (const auto& priority : priorities()) {
    const auto domain = materials_domain(crowd(), {.size = 0.04}, priority);
    EXPECT_EQ(materials::first_contradiction(random, *domain, domain->lattice(), 300, decided), "");
  }
  EXPECT_GT(decided, 3);
}

/// Edges of the lattice whose ends are of different materials.
std::vector<PartedEdge> parted_edges(std::mt19937_64& random, const PlacedDomain& domain,
                                     const Definition& definition) {
  const auto vertex = [](core::VertexRef ref, Coord3 index) {
    const std::int32_t g = ref.grid == core::odd ? 1 : 0;
    return 2 * (index + Coord3{ref.shift.x, ref.shift.y, ref.shift.z}) + Coord3{g, g, g};
  };
  std::vector<PartedEdge> edges;
  while (edges.size() < 600) {
    const Coord3 p = random_position(random, domain.lattice());
    const Coord3 index{p.x / (2 * steps), p.y / (2 * steps), p.z / (2 * steps)};
    for (const core::Family& family : core::families) {
      Coord3 a = vertex(family.first, index), b = vertex(family.second, index);
      Material of_a = definition.material(steps * a), of_b = definition.material(steps * b);
      if (of_a == of_b) continue;
      if (of_a < of_b) std::swap(a, b), std::swap(of_a, of_b);
      edges.push_back({a, b, of_b, of_a});
    }
  }
  return edges;
}

/// Edges that are not cut at the surface of the stronger or, for comparison, of the weaker of
/// both materials: at the cut is that solid, or its surface, and one step beyond it is not,
/// or its surface is.
int wrong_cuts(const std::vector<PartedEdge>& edges, const std::vector<std::uint16_t>& cuts,
               const Definition& definition, bool of_weaker) {
  int wrong = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const PartedEdge& edge = edges[e];
    if (edge.of_last == 0) continue;
    const Material solid = of_weaker ? edge.of_last : edge.of_first;
    const auto sign = [&](std::int32_t t) {
      return definition.sign(solid, steps * edge.first + t * (edge.last - edge.first));
    };
    const std::int32_t cut = cuts[e], beyond = of_weaker ? cut - 1 : cut + 1;
    wrong += sign(cut) != Sign::on_surface && sign(cut) == sign(beyond);
  }
  return wrong;
}

/// Where the wall has a lattice point the cut is there, whichever solid is the stronger.
TEST(MaterialsDomain, EdgesPartAtTheSurfaceOfTheStronger) {
  std::mt19937_64 random(test_seed());
  for (const auto& priority : priorities()) {
    const auto domain = materials_domain(crowd(), {.size = 0.25}, priority);
    const Definition definition(crowd(), *domain, priority);
    const std::vector<PartedEdge> edges = parted_edges(random, *domain, definition);
    std::vector<std::uint16_t> cuts(edges.size());
    domain->part(edges, cuts);
    EXPECT_EQ(wrong_cuts(edges, cuts, definition, false), 0);
    EXPECT_GT(wrong_cuts(edges, cuts, definition, true), 50);
    int at_points = 0;
    for (std::size_t e = 0; e < edges.size(); ++e)
      at_points += cuts[e] == 0 && edges[e].of_last != 0;
    EXPECT_GT(at_points, 5);
  }
}

/// From a material to the outside an edge is cut where the material ends.
TEST(MaterialsDomain, TheOutsideBeginsWhereASolidEnds) {
  std::mt19937_64 random(test_seed());
  const auto domain = materials_domain(crowd(), {.size = 0.25});
  const Definition definition(crowd(), *domain, {});
  const std::vector<PartedEdge> edges = parted_edges(random, *domain, definition);
  std::vector<std::uint16_t> cuts(edges.size());
  domain->part(edges, cuts);
  int seen = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].of_last != 0) continue;
    ++seen;
    const Coord3 at = steps * edges[e].first + cuts[e] * (edges[e].last - edges[e].first);
    const Sign there = definition.sign(edges[e].of_first, at);
    const Sign next =
        definition.sign(edges[e].of_first, at + (edges[e].last - edges[e].first));
    EXPECT_TRUE(there == Sign::on_surface || (there == Sign::plus && next != Sign::plus));
  }
  EXPECT_GT(seen, 50);
}

TEST(MaterialsDomain, AnEdgeIsCutAsIfItWereAlone) {
  std::mt19937_64 random(test_seed());
  const auto domain = materials_domain(crowd(), {.size = 0.25}, {"block"});
  const Definition definition(crowd(), *domain, {"block"});
  const std::vector<PartedEdge> edges = parted_edges(random, *domain, definition);
  std::vector<std::uint16_t> together(edges.size());
  domain->part(edges, together);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::uint16_t alone = 0;
    domain->part({&edges[e], 1}, {&alone, 1});
    ASSERT_EQ(alone, together[e]) << e;
  }
}

TEST(MaterialsDomain, LatticeNamesAndLabels) {
  const auto domain = materials_domain(crowd(), {.size = 0.25, .margin = 3});
  EXPECT_TRUE(std::ranges::equal(domain->labels(), std::vector<std::int32_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(domain->names().at(3), "beside");
  EXPECT_EQ(domain->longest_side(), 3);
  // From -1.25 to 1.5, from -1.5 to 1.5 and from -1.1 to 1.25: even numbers of cells.
  EXPECT_EQ(domain->lattice().cells, (std::array<std::int32_t, 3>{18, 18, 16}));
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_NEAR(domain->frame().origin[a], (Point3{0.125, 0, 0.075})[a], 1e-12);
  EXPECT_EQ(materials_domain(crowd(), {})->frame().size, 3. / 64);
}

TEST(MaterialsDomain, Refusals) {
  EXPECT_THROW(static_cast<void>(materials_domain({}, {})), Error);
  EXPECT_THROW(static_cast<void>(materials_domain(crowd(), {}, {"nobody"})), Error);
  EXPECT_THROW(static_cast<void>(materials_domain(crowd(), {.size = -1})), Error);
  EXPECT_THROW(static_cast<void>(shape_solid("cube:1")), Error);
  TriangleSurface open = surfaces::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(static_cast<void>(solids::inside(open)), Error);
  EXPECT_THROW(static_cast<void>(formula_solid("x+", {{0, 0, 0}, {1, 1, 1}})), Error);
}

/// A solid that its own lattice would not hold.
TEST(MaterialsDomain, ASurfaceFarBeyondTheLatticeIsRefused) {
  const Solid far = solids::block({0, 0, 0}, {1e7, 1, 1});
  const PlacedLattice small = lattice_around({{0, 0, 0}, {1, 1, 1}}, 0.1, 2);
  EXPECT_THROW(static_cast<void>(far.on(small)), Error);
}

}  // namespace
}  // namespace certet
