/// \file
/// Several materials: all patterns in which they meet in a structured tetrahedron, the test
/// of its shape, and whole meshes.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <sstream>

#include "certet/lattice/material_stencil.hpp"
#include "certet/lattice/well_shaped.hpp"
#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "domains.hpp"
#include "materials.hpp"
#include "placed_materials.hpp"
#include "seed.hpp"
#include "vertex_arena.hpp"
#include "whole_mesh.hpp"

namespace {

using certet::Coord3;
using certet::CornerMaterials;
using certet::Lattice;
using certet::MaterialStencil;
using certet::Method;
using certet::moved_corner;
using certet::StencilVertex;
using certified::Handle;
using certified::PlacedMaterialTet;

// -- All patterns -------------------------------------------------------------------------

/// Of a cut edge, the end of the higher material is first.
using PlacedMaterialTets = std::vector<certified::OfMaterial<Place>>;

/// The material of a tetrahedron all of whose corners have moved; none of theirs.
constexpr std::int32_t shared_material = 1000;

using Stencils = std::function<MaterialStencil(const CornerMaterials&)>;
const Stencils production = [](const CornerMaterials& corners) {
  return certet::material_tets(corners);
};

PlacedMaterialTets place(const MaterialStencil& stencil, const CornerMaterials& corners,
                         const std::array<Coord3, 4>& vertices) {
  PlacedMaterialTets tets;
  for (const certet::MaterialTet& tet : stencil) {
    auto& [material, places] = tets.emplace_back();
    material = tet.owner == certet::shared_owner ? shared_material : corners[tet.owner];
    std::ranges::transform(tet.vertices, places.begin(), [&](StencilVertex v) {
      if (corners[v.a] < corners[v.b]) std::swap(v.a, v.b);
      return Place{vertices[v.a], vertices[v.b]};
    });
  }
  return tets;
}

PlacedMaterialTets certified_tets(const CornerMaterials& corners,
                                  const std::array<Coord3, 4>& vertices) {
  VertexArena arena(vertices);
  const auto corner = VertexArena::corner;
  const auto tets = certified::material_tets(
      [&](Handle h) -> std::optional<certified::Material> {
        if (corners[corner(h)] == moved_corner) return std::nullopt;
        return corners[corner(h)];
      },
      [&](Handle a, Handle b) { return arena.cut(a, b); },
      {0, 1, 2, 3}, shared_material);
  PlacedMaterialTets placed;
  for (const auto& [material, handles] : tets) {
    auto& tet = placed.emplace_back();
    tet.material = material;
    std::ranges::transform(handles, tet.vertices.begin(),
                           [&](Handle h) { return arena.at(h); });
  }
  return placed;
}

std::string show(const CornerMaterials& corners) {
  std::string text;
  for (const std::int32_t m : corners) text += ' ' + std::to_string(m);
  return text;
}

/// Every structured tetrahedron, every corner moved or of one of four materials, which are
/// numbered in three ways.
Differences compare_patterns(const Stencils& stencils) {
  Differences differences;
  constexpr std::array<CornerMaterials, 3> numberings{{{0, 1, 2, 3}, {7, 0, 40000, 3}, {3, 2, 1, 0}}};
  for (const certet::StructuredTetCase orientation : certified::all_cases()) {
    const auto vertices = certified::structured_tet({{2, -4, 6}, orientation}).vertices;
    for (const CornerMaterials& materials : numberings)
      for (int n = 0; n < 5 * 5 * 5 * 5; ++n) {
        CornerMaterials corners{};
        for (int rest = n; std::int32_t& m : corners) {
          m = rest % 5 == 4 ? moved_corner : materials[static_cast<std::size_t>(rest % 5)];
          rest /= 5;
        }
        differences.expect(
            place(stencils(corners), corners, vertices) == certified_tets(corners, vertices),
            [&] { return "materials" + show(corners); });
      }
  }
  return differences;
}

TEST(Materials, StencilsAreTheSameForAllPatterns) {
  const Differences differences = compare_patterns(production);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 12 * 3 * 625);
}

/// The stencils with one changed.
Stencils with(const CornerMaterials& pattern, const std::function<void(MaterialStencil&)>& spoil) {
  return [=](const CornerMaterials& corners) {
    MaterialStencil stencil = certet::material_tets(corners);
    if (certet::likeness(corners) == certet::likeness(pattern)) spoil(stencil);
    return stencil;
  };
}

bool is_caught(const CornerMaterials& pattern, const std::function<void(MaterialStencil&)>& spoil) {
  return !compare_patterns(with(pattern, spoil)).empty();
}

TEST(Materials, CatchesAFillOfAnotherMaterial) {
  EXPECT_TRUE(is_caught({1, 1, 2, 3}, [](MaterialStencil& s) { s.tets[s.count - 1].owner = 2; }));
}

/// The fill of a long edge of one material is divided along the other diagonal.
TEST(Materials, CatchesAFillWithTheOtherDiagonal) {
  EXPECT_TRUE(is_caught({1, 1, 2, 3}, [](MaterialStencil& s) {
    constexpr StencilVertex c13{0, 2}, c14{0, 3}, c23{1, 2}, c24{1, 3}, c34{2, 3};
    s.tets[s.count - 2].vertices = {c13, c14, c24, c34};
    s.tets[s.count - 1].vertices = {c13, c24, c23, c34};
  }));
}

TEST(Materials, CatchesAFillThatIsMissing) {
  EXPECT_TRUE(is_caught({moved_corner, 1, 2, 3}, [](MaterialStencil& s) { --s.count; }));
}

TEST(Materials, CatchesAMirroredFill) {
  EXPECT_TRUE(is_caught({1, 2, 3, 4}, [](MaterialStencil& s) {
    std::swap(s.tets[7].vertices[0], s.tets[7].vertices[1]);
  }));
}

TEST(Materials, CatchesASharedTetrahedronThatIsDropped) {
  EXPECT_TRUE(is_caught({moved_corner, moved_corner, moved_corner, moved_corner},
                        [](MaterialStencil& s) { s.count = 0; }));
}

// -- The shape of a tetrahedron -----------------------------------------------------------

using Test = std::function<bool(const certified::PlacedTet&)>;

/// Tetrahedra of every kind of shape; and of such as are well shaped and as are not, those
/// between that are one step apart.
Differences compare_shapes(const Test& is_well_shaped) {
  Differences differences;
  std::mt19937_64 random(test_seed());
  const auto ask = [&](const certified::PlacedTet& tet) {
    const bool theirs = certified::is_well_shaped(tet);
    differences.expect(is_well_shaped(tet) == theirs, [&] {
      std::ostringstream out;
      for (const Coord3 p : tet) out << " (" << materials::text(p) << ')';
      return out.str();
    });
    return theirs;
  };
  const auto moved = [&](Coord3 p, std::int32_t far) {
    return p + Coord3{between(random, -far, far), between(random, -far, far), between(random, -far, far)};
  };
  for (int n = 0; n < 1000; ++n) {
    const auto c = static_cast<certet::StructuredTetCase>(n % certet::case_count);
    certified::PlacedTet tet = certified::structured_tet({{0, 0, 0}, c}).vertices;
    if (!certet::right_handed(c)) std::swap(tet[2], tet[3]);
    const std::int32_t far = std::array{20000, 40000, 60000}[static_cast<std::size_t>(n % 3)];
    const Coord3 at_rest = certet::steps * tet[0];
    for (Coord3& p : tet) p = moved(certet::steps * p, far);
    const bool first = ask(tet);
    // Towards another place of one corner, where the answer may change.
    const Coord3 from = tet[0];
    const Coord3 by = moved(at_rest, far) - from;
    std::int32_t low = 0;
    std::int32_t high = certet::steps;
    const auto at = [&](std::int32_t t) {
      const auto part = [&](std::int32_t c) {
        return static_cast<std::int32_t>(std::int64_t{c} * t / certet::steps);
      };
      tet[0] = from + Coord3{part(by.x), part(by.y), part(by.z)};
      return ask(tet);
    };
    if (at(high) == first) continue;
    while (high - low > 1) {
      const std::int32_t middle = (low + high) / 2;
      (at(middle) == first ? low : high) = middle;
    }
  }
  return differences;
}

TEST(Materials, ShapesAreJudgedAlike) {
  const Differences differences = compare_shapes(certet::is_well_shaped);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GT(differences.compared(), 1500);
}

TEST(Materials, CatchesAnotherTestOfShapes) {
  EXPECT_FALSE(compare_shapes([](const certified::PlacedTet& p) {
                 return certet::six_volume(p[0], p[1], p[2], p[3]) > 0;
               }).empty());
}

// -- Whole meshes -------------------------------------------------------------------------

using Engine = std::function<MaterialMesh(const materials::Positional&, const Lattice&, Method)>;

MaterialMesh engine(const materials::Positional& domain, const Lattice& lattice, Method method) {
  return placed_by_material(whole_mesh(domain, lattice, method));
}

MaterialMesh reference(const materials::Positional& domain, const Lattice& lattice,
                       Method method) {
  const certified::MaterialDomain seen = seen_on(lattice, domain);
  if (method == Method::midpoint) return certified::halve_materials(lattice, seen.material);
  const certet::Thresholds alpha = certet::facts(method).thresholds;
  return certified::settle_materials({alpha.long_edge, alpha.short_edge}, lattice, seen);
}

Differences compare(const Engine& production_engine, const materials::Positional& domain,
                    const Lattice& lattice, Method method) {
  return compare_by_material(production_engine(domain, lattice, method),
                             reference(domain, lattice, method));
}

/// Three balls that overlap, of three materials.
materials::Positional balls() {
  return {{1, 2, 3}, [](Coord3 p) -> certet::Material {
            constexpr std::array<std::array<double, 4>, 3> all{
                {{-1.3, 0.2, 0.1, 4.1}, {2.2, 0.7, -0.4, 3.7}, {0.4, -2.1, 0.8, 3.3}}};
            constexpr double unit = certet::steps;
            certet::Material material = 0;
            double least = 0;
            for (std::size_t n = 0; n < all.size(); ++n) {
              const auto& [x, y, z, r] = all[n];
              const double level = domains::sphere(x, y, z, r)(p.x / unit, p.y / unit, p.z / unit);
              if (level >= least) continue;
              least = level;
              material = static_cast<certet::Material>(n + 1);
            }
            return material;
          }};
}

/// Cuts on, just below and just above the thresholds, seen from either end, and at the ends.
std::vector<std::int32_t> cuts_near_thresholds() {
  std::vector<std::int32_t> cuts{0, 1, certet::steps / 2, certet::steps - 1};
  for (const int direction : {0, 6})
    for (const std::int32_t beside : {-4000, -1, 0, 1}) {
      cuts.push_back(certet::angle_thresholds.in_steps(direction) + beside);
      cuts.push_back(certet::steps - certet::angle_thresholds.in_steps(direction) + beside);
    }
  return cuts;
}

std::vector<std::int32_t> labels_up_to(std::int32_t most) {
  std::vector<std::int32_t> labels;
  for (std::int32_t n = 1; n <= most; ++n) labels.push_back(n);
  return labels;
}

/// Three materials that meet in walls across long edges near their quarters, rough: vertices
/// move onto a wall from either side, and whole tetrahedra end between interfaces.
materials::Positional walls(std::uint64_t seed) {
  return {{1, 2, 3}, [=](Coord3 p) -> certet::Material {
            const auto nearest = [](std::int32_t c) { return (c + certet::steps / 2) >> certet::step_bits; };
            const std::uint64_t h = mixed(seed, nearest(p.y), nearest(p.z));
            const auto rough = static_cast<std::int32_t>(h % 9000) - 4500;
            const std::int32_t from_wall = p.x - 9 * certet::steps / 2 - rough;
            return from_wall <= 0 ? 1 : p.y <= 7 * certet::steps / 2 ? 2 : 3;
          }};
}

materials::Positional random_domain(std::uint64_t seed) {
  const auto labels = labels_up_to(static_cast<std::int32_t>(2 + seed / 5 % 4));
  const unsigned outside = std::array{0U, 40U, 120U}[seed / 20 % 3];
  switch (seed % 5) {
    case 0: return materials::cubes(seed, 3, labels, outside);
    case 1: return materials::noise(seed, labels, outside);
    case 2: return materials::random_cuts(seed, labels, outside, cuts_near_thresholds());
    case 3: return walls(seed);
    default:  // all near one end, so that much moves
      return materials::random_cuts(seed, labels, outside, {40, 9000, 15000});
  }
}

constexpr std::array interface_methods{Method::embedded, Method::midpoint};

TEST(Materials, MeshOfThreeBallsIsTheSame) {
  for (const Method method : interface_methods) {
    const Differences differences = compare(engine, balls(), {{-8, -8, -8}, {9, 9, 9}}, method);
    EXPECT_TRUE(differences.empty()) << differences;
    EXPECT_GT(differences.compared(), 1000);
  }
}

/// Random domains; `first` of them, or until one differs.
Differences compare_random(const Engine& production_engine, int first) {
  Differences all;
  for (int n = 0; n < first && all.empty(); ++n) {
    const std::uint64_t seed = mixed(test_seed(), n);
    const auto extent = [&](std::uint64_t shift) {
      return static_cast<std::int32_t>(3 + (seed >> shift) % 4);
    };
    const Lattice lattice{{0, -2, 2}, {extent(20), extent(24), extent(28)}};
    for (const Method method : interface_methods) {
      const Differences differences =
          compare(production_engine, random_domain(seed >> 8), lattice, method);
      all.expect(differences.empty(), [&] {
        std::ostringstream out;
        out << "random domain " << n << ", " << certet::name(method) << ": " << differences;
        return out.str();
      });
    }
  }
  return all;
}

TEST(Materials, MeshesOfRandomDomainsAreTheSame) {
  const Differences differences = compare_random(engine, 150);
  EXPECT_TRUE(differences.empty()) << differences;
}

/// Of two materials, and hardly anything outside, that are cut near one end of their edges: there
/// tetrahedra with four corners that moved are kept.
Differences compare_shared(const Engine& production_engine, int first) {
  Differences all;
  for (int n = 0; n < first && all.empty(); ++n) {
    const unsigned outside = n % 2 == 0 ? 0 : 4;
    all = compare(production_engine,
                  materials::random_cuts(mixed(test_seed(), n), {1, 2}, outside, {40, 9000, 15000}),
                  {{0, 0, 0}, {7, 7, 7}}, Method::embedded);
  }
  return all;
}

TEST(Materials, MeshesOfSharedTetrahedraAreTheSame) {
  const Differences differences = compare_shared(engine, 40);
  EXPECT_TRUE(differences.empty()) << differences;
}

using Spoil = std::function<void(MaterialMesh&, const materials::Positional&, const Lattice&)>;

Engine spoiled(const Spoil& spoil) {
  return [=](const auto& domain, const Lattice& lattice, Method method) {
    MaterialMesh mesh = engine(domain, lattice, method);
    if (!mesh.empty()) spoil(mesh, domain, lattice);
    return mesh;
  };
}

bool is_caught(const Engine& broken) {
  return !compare(broken, balls(), {{-8, -8, -8}, {9, 9, 9}}, Method::embedded).empty();
}

TEST(Materials, CatchesOneStepOfOneVertex) {
  EXPECT_TRUE(is_caught(spoiled([](auto& mesh, auto&&...) { ++mesh.back().vertices[1].x; })));
}

TEST(Materials, CatchesATetrahedronOfAnotherMaterial) {
  EXPECT_TRUE(is_caught(spoiled([](auto& mesh, auto&&...) {
    mesh.front().material = mesh.front().material % 3 + 1;
  })));
}

TEST(Materials, CatchesATetrahedronOutOfOrder) {
  EXPECT_TRUE(is_caught(spoiled([](auto& mesh, auto&&...) { std::swap(mesh[0], mesh[1]); })));
}

/// Cuts, and moves that were shortened, are put where the domain has them.
TEST(Materials, CatchesAClampThatIsForgotten) {
  const auto forget = [](MaterialMesh& mesh, const materials::Positional& domain,
                         const Lattice& lattice) {
    for (PlacedMaterialTet& tet : mesh)
      for (Coord3& p : tet.vertices) {
        const auto [a, b, t] = domains::edge_of(p);
        if (t == 0) continue;
        const auto material = [&](Coord3 v) { return sample(domain, lattice, v); };
        if (material(a) == material(b)) continue;
        const bool forward = material(a) > material(b);
        const Coord3 higher = forward ? a : b;
        const Coord3 lower = forward ? b : a;
        p = certified::point_on_edge(higher, lower, cut_of(domain, lattice, higher, lower));
      }
  };
  EXPECT_FALSE(compare_random(spoiled(forget), 40).empty());
}

/// Of several materials the labels are cut apart, of one they would not be.
TEST(Materials, CatchesMaterialsTakenForOne) {
  const Engine one = [](const materials::Positional& domain, const Lattice& lattice, Method method) {
    const materials::Positional solid({1, 2}, [&](Coord3 p) -> certet::Material {
      return domain.material_at(p) == 0 ? 0 : 1;
    });
    return engine(solid, lattice, method);
  };
  EXPECT_TRUE(is_caught(one));
}

}  // namespace
