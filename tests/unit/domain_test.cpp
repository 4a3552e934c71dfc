/// What a domain answers of its materials, and what is made of it by default:
/// against the definitions, position by position.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "certet/domain.hpp"
#include "certet/error.hpp"
#include "certet/material_runs.hpp"
#include "domains.hpp"
#include "engine/border.hpp"
#include "lattice/lattice_edges.hpp"
#include "materials.hpp"

namespace certet {
namespace {

using core::families;

Coord3 vertex(core::VertexRef ref, Coord3 index) {
  const std::int32_t g = ref.grid == core::odd ? 1 : 0;
  return 2 * (index + Coord3{ref.shift.x, ref.shift.y, ref.shift.z}) + Coord3{g, g, g};
}

/// Edges of all families, both ways, around random places.
template <class Visit>
void for_edges(std::uint64_t seed, int places, const Visit& visit) {
  std::mt19937_64 random(seed);
  for (int n = 0; n < places; ++n) {
    const Coord3 index{between(random, -40, 40), between(random, -40, 40),
                       between(random, -40, 40)};
    for (const core::Family& family : families) {
      const Coord3 a = vertex(family.first, index), b = vertex(family.second, index);
      visit(a, b);
      visit(b, a);
    }
  }
}

Coord3 along(const PartedEdge& edge, std::int32_t t) {
  return steps * edge.first + t * (edge.last - edge.first);
}

/// How `Domain::part` finds a cut, one edge at a time.
using Rule = std::function<bool(Coord3 position, const PartedEdge&)>;

std::uint16_t bisected(const PartedEdge& edge, const Rule& is_first_side) {
  std::int32_t low = 0;
  for (std::int32_t half = steps / 2; half > 0; half /= 2)
    if (is_first_side(along(edge, low + half), edge)) low += half;
  return static_cast<std::uint16_t>(low);
}

/// Rounded cubes that lie in one another's way, so that a third material often is
/// between two.
materials::Positional crowd(std::uint64_t seed) { return materials::cubes(seed, 1, {3, 5, 9}, 64); }

std::vector<PartedEdge> parted_edges(const materials::Positional& domain, std::uint64_t seed) {
  std::vector<PartedEdge> edges;
  for_edges(seed, 60, [&](Coord3 a, Coord3 b) {
    const Material first = domain.material_at(steps * a), last = domain.material_at(steps * b);
    if (first > last) edges.push_back({a, b, last});
  });
  return edges;
}

/// What it says of its edges, all at once.
struct PartedCrowd {
  materials::Positional domain;
  std::vector<PartedEdge> edges;
  std::vector<std::uint16_t> cuts;
};

PartedCrowd parted_crowd(std::uint64_t seed) {
  const materials::Positional domain = crowd(seed);
  PartedCrowd parted{domain, parted_edges(domain, seed), {}};
  parted.cuts.resize(parted.edges.size());
  domain.part(parted.edges, parted.cuts);
  return parted;
}

TEST(Part, BisectsTheMaterialOfTheLastEndAgainstTheRest) {
  const PartedCrowd crowd = parted_crowd(test_seed());
  const auto wrong = [&](const Rule& rule) {
    std::size_t count = 0;
    for (std::size_t e = 0; e < crowd.edges.size(); ++e) count += crowd.cuts[e] != bisected(crowd.edges[e], rule);
    return count;
  };
  EXPECT_GT(crowd.edges.size(), 500u);
  EXPECT_EQ(wrong([&](Coord3 p, const PartedEdge& edge) {
              return crowd.domain.material_at(p) != edge.of_last;
            }),
            0u);
  // Another rule would be noticed: a third material belongs to the first end.
  EXPECT_GT(wrong([&](Coord3 p, const PartedEdge& edge) {
              return crowd.domain.material_at(p) == crowd.domain.material_at(steps * edge.first);
            }),
            0u);
}

/// The step before the cut is of the first side, the cut's next step of the last.
TEST(Part, IsExactToOneStepWhereNothingIsInBetween) {
  const auto domain = materials::Positional({1, 2}, [](Coord3 p) -> Material {
    return p.x + 3 * p.y < 5 * p.z + 777 ? 1 : 2;
  });
  std::size_t seen = 0;
  for_edges(1, 3000, [&](Coord3 a, Coord3 b) {
    if (domain.material_at(steps * a) != 2 || domain.material_at(steps * b) != 1) return;
    const PartedEdge edge{a, b, 1};
    std::uint16_t cut = 0;
    domain.part({&edge, 1}, {&cut, 1});
    ++seen;
    EXPECT_EQ(domain.material_at(along(edge, cut)), 2);
    EXPECT_EQ(domain.material_at(along(edge, cut + 1)), 1);
  });
  EXPECT_GT(seen, 50u);
}

/// However they are mixed, and however many there are at once.
TEST(Part, EdgesDoNotTouchEachOther) {
  const PartedCrowd together = parted_crowd(test_seed());
  for (std::size_t e = 0; e < together.edges.size(); ++e) {
    std::uint16_t alone = 0;
    together.domain.part({&together.edges[e], 1}, {&alone, 1});
    ASSERT_EQ(together.cuts[e], alone);
  }
  together.domain.part({}, {});
}

/// Out of the solid it is the bisection of signs, which ends on the surface.
TEST(Part, EndsOnTheSurfaceOfASolid) {
  const PartedEdge edge{{0, 0, 0}, {2, 0, 0}, 0};
  const auto cut = [&](const domains::Positional& solid) {
    std::uint16_t found = 0;
    solid.part({&edge, 1}, {&found, 1});
    return found;
  };
  const auto of = [](std::int32_t low, std::int32_t high) {
    return domains::Positional([=](Coord3 p) {
      const std::int32_t t = p.x / 2;
      return t < low ? Sign::plus : t <= high ? Sign::on_surface : Sign::minus;
    });
  };
  EXPECT_EQ(cut(of(12345, 12345)), 12345);
  EXPECT_EQ(cut(of(30000, 40000)), 32768);  // the first that is asked for
  EXPECT_EQ(cut(of(777, 776)), 776);
  EXPECT_EQ(cut(of(steps, steps)), 65535);
}

/// A solid of one material says of it what it says of its signs.
TEST(Solid, HasOneMaterial) {
  const auto solid = domains::of_level(domains::box(-8, 8));
  std::mt19937_64 random(test_seed());
  int decided = 0;
  EXPECT_TRUE(solid.labels().empty());
  EXPECT_EQ(materials::first_contradiction(random, solid, {{-12, -12, -12}, {12, 12, 12}}, 40,
                                           decided), "");
  std::array<Material, 3> row;
  solid.row_materials({-10, 0, 0}, row);
  EXPECT_EQ(row, (std::array<Material, 3>{0, 1, 1}));  // the second is on the surface
  TetCorners tet{};
  Material material = 7;
  solid.materials_of({&tet, 1}, {&material, 1});
  EXPECT_EQ(material, 1);
}

/// Blocks are known where the extent is.
class Known final : public domains::Positional {
 public:
  explicit Known(Extent extent)
      : Positional([](Coord3) { return Sign::plus; }), extent_(extent) {}
  [[nodiscard]] Extent extent(const LatticeBox&) const override { return extent_; }

 private:
  Extent extent_;
};

TEST(Solid, TheMaterialOfABoxIsItsExtent) {
  EXPECT_EQ(Known(Extent::inside).material_of({}), 1);
  EXPECT_EQ(Known(Extent::outside).material_of({}), 0);
  EXPECT_EQ(Known(Extent::mixed).material_of({}), std::nullopt);
}

/// The search for contradictions finds those that are planted.
TEST(Materials, ContradictionsAreFound) {
  struct Planted final : materials::Positional {
    Planted() : Positional(materials::cubes(1, 3, {1, 2, 3}, 80)) {}
    int plant = 0;
    [[nodiscard]] std::optional<Material> material_of(const LatticeBox& box) const override {
      return plant == 1 ? std::optional<Material>(2) : Positional::material_of(box);
    }
    void row(Coord3 first, std::span<Sign> out) const override {
      Positional::row(first, out);
      if (plant == 2) out[1] = Sign::plus;
    }
    void row_materials(Coord3 first, std::span<Material> out) const override {
      Positional::row_materials(plant == 3 ? first + Coord3{2, 0, 0} : first, out);
    }
    void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
      Positional::materials_at(positions, out);
      for (Material& material : out)
        if (plant == 4 && material == 3) material = 1;
    }
  } domain;
  const Lattice lattice{{-20, -20, -20}, {20, 20, 20}};
  for (domain.plant = 0; domain.plant <= 4; ++domain.plant) {
    std::mt19937_64 random(5);
    int decided = 0;
    EXPECT_EQ(materials::first_contradiction(random, domain, lattice, 20, decided).empty(),
              domain.plant == 0)
        << domain.plant;
  }
}

/// By definition: the centroid, or else the nearest corner that is inside.
Material defined(const materials::Positional& domain, const TetCorners& tet) {
  const auto sum = [&](auto axis) { return tet[0].*axis + tet[1].*axis + tet[2].*axis + tet[3].*axis; };
  const Coord3 four{sum(&Coord3::x), sum(&Coord3::y), sum(&Coord3::z)};
  const auto floor4 = [](std::int32_t v) { return v >= 0 ? v / 4 : -((3 - v) / 4); };
  if (const Material found = domain.material_at({floor4(four.x), floor4(four.y), floor4(four.z)}))
    return found;
  double least = std::numeric_limits<double>::infinity();
  Material nearest = 0;
  for (const Coord3 corner : tet) {
    const Coord3 d = 4 * corner - four;
    const double distance = double(d.x) * d.x + double(d.y) * d.y + double(d.z) * d.z;
    if (domain.material_at(corner) == 0 || distance >= least) continue;
    least = distance;
    nearest = domain.material_at(corner);
  }
  return nearest;
}

TEST(Materials, OfTetrahedraAreThoseOfCentroidsOrCorners) {
  std::mt19937_64 random(test_seed());
  const materials::Positional domain = materials::cubes(random(), 1, {-7, 0, 12}, 140);
  std::vector<TetCorners> tets(1000);
  for (TetCorners& tet : tets) {
    const Coord3 at{between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)};
    for (Coord3& corner : tet)
      corner = steps * at + Coord3{between(random, 0, 2 * steps), between(random, 0, 2 * steps),
                                   between(random, 0, 2 * steps)};
  }
  std::vector<Material> found(tets.size());
  domain.materials_of(tets, found);
  std::size_t by_corner = 0, outside = 0;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    ASSERT_EQ(found[i], defined(domain, tets[i]));
    outside += found[i] == 0;
    const bool of_first = domain.material_at(tets[i][0]) == found[i];
    by_corner += !of_first;
  }
  EXPECT_GT(by_corner, 100u);  // no simpler rule would do
  EXPECT_GT(outside, 0u);
}

TEST(Border, TheMiddleOfAnEdgeTellsItsEnds) {
  for_edges(test_seed(), 300, [](Coord3 a, Coord3 b) {
    const Coord3 middle = steps / 2 * (a + b);
    const auto ends = core::ends_of_middle(middle);
    EXPECT_TRUE((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
        << materials::text(a) << ", " << materials::text(b);
  });
}

/// Of a turned frame, box by box and method by method.
TEST(Border, IsWhereTheBoxesHaveTheirFaces) {
  const Frame frame{{1, 2, 3}, {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}, 0.5};
  const auto world = [&](double x, double y, double z) -> Point3 {
    return {1 - 0.25 * y, 2 + 0.25 * x, 3 + 0.25 * z};
  };
  // From -3 to 5.5 lattice units along x, -4 to 4 along y, far along z.
  const Point3 corner = world(-3, -4, -100), opposite = world(5.5, 4, 100);
  for (const BorderBox& box : {BorderBox::along_frame(frame, corner, opposite),
                               BorderBox::along_world(frame, corner, opposite)}) {
    const std::array<BorderBox, 1> boxes{box};
    const auto bisected = [&](Coord3 p) { return core::is_on_border(p, boxes, Cuts::bisect); };
    const auto middle = [&](Coord3 p) { return core::is_on_border(p, boxes, Cuts::midpoint); };
    EXPECT_TRUE(bisected({-3 * steps, 0, 0}));
    EXPECT_TRUE(bisected({-3 * steps + 4, 7, 9}));
    EXPECT_FALSE(bisected({-3 * steps + 5, 7, 9}));
    EXPECT_TRUE(bisected({5 * steps + steps / 2, 0, 0}));
    EXPECT_TRUE(bisected({0, 4 * steps - 3, 0}));
    EXPECT_FALSE(bisected({0, 4 * steps - 5, 0}));
    // The long edges from x = 4 to 6 and from 2 to 4; the first leaves the box.
    EXPECT_TRUE(middle({5 * steps, 0, 0}));
    EXPECT_FALSE(middle({3 * steps, 0, 0}));
    // A short edge from (6,2,2) to (5,1,1).
    EXPECT_TRUE(middle({5 * steps + steps / 2, steps + steps / 2, steps + steps / 2}));
    // y = 4 is in the box still, 5 and 6 are not.
    EXPECT_FALSE(middle({0, 3 * steps, 0}));
    EXPECT_TRUE(middle({0, 5 * steps, 0}));
  }
  EXPECT_FALSE(core::is_on_border({0, 0, 0}, {}, Cuts::bisect));
  EXPECT_FALSE(core::is_on_border({steps, 0, 0}, {}, Cuts::midpoint));
}

TEST(MaterialRuns, GiveBackWhatWasPut) {
  std::mt19937_64 random(test_seed());
  constexpr std::int32_t layers = 12;
  std::vector<std::vector<Material>> put(layers);
  MaterialRuns runs(layers);
  EXPECT_TRUE(MaterialRuns().empty());
  EXPECT_FALSE(runs.empty());
  const std::array<Material, 6> some{0, 1, 127, 128, 70000, std::numeric_limits<Material>::max()};
  const std::array<std::size_t, 6> lengths{1, 2, 128, 129, 16384, 16385};
  for (std::int32_t layer = 0; layer < layers - 1; ++layer) {
    std::vector<Material>& materials = put[static_cast<std::size_t>(layer)];
    for (int run = 0; run < 40; ++run)
      materials.insert(materials.end(), lengths[random() % 6], some[random() % 6]);
    runs.put(layer, materials);
  }
  runs.put(layers - 1, {});
  for (std::int32_t layer = 0; layer < layers; ++layer) {
    std::vector<Material> got(put[static_cast<std::size_t>(layer)].size(), -1);
    runs.get(layer, got);
    EXPECT_EQ(got, put[static_cast<std::size_t>(layer)]);
  }
}

TEST(MaterialRuns, AreSmall) {
  MaterialRuns runs(1);
  const std::uint64_t empty = runs.bytes();
  std::vector<Material> materials;
  for (int run = 0; run < 1000; ++run)
    materials.insert(materials.end(), 128, run % 2 == 0 ? 1 : 127);
  runs.put(0, materials);
  EXPECT_EQ(runs.bytes(), empty + 2000);
}

}  // namespace
}  // namespace certet
