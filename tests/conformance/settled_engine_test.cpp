/// \file
/// The engine passes the kit's cases of the warp that keeps the shape, of several materials,
/// and of graded interiors.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "certet/lattice/material_stencil.hpp"
#include "certet/stuffing.hpp"
#include "engine/link.hpp"
#include "kit_cases.hpp"
#include "materials.hpp"
#include "whole_mesh.hpp"

namespace {

using namespace conformance;
using certet::Method;
using certet::core::LinkSet;

// -- Links --------------------------------------------------------------------------------

using IsDisk = std::function<bool(LinkSet plus, LinkSet zero)>;

/// Where no 0 may be, and where no two.
struct Row {
  LinkSet nowhere = 0;
  std::vector<LinkSet> not_both;
};

/// All 3^14 links.
Differences disks(const IsDisk& is_disk) {
  std::map<LinkSet, Row> rows;
  for (const json& row : kit().at("disks")) {
    Row& read = rows[row.at(0).get<LinkSet>()];
    read.nowhere = row.at(1).get<LinkSet>();
    for (const json& wall : row.at(2))
      read.not_both.push_back(LinkSet{1} << wall.at(0).get<int>() |
                              LinkSet{1} << wall.at(1).get<int>());
  }
  Differences differences;
  for (LinkSet plus = 0; plus <= certet::core::whole_link; ++plus) {
    const auto row = rows.find(plus);
    const auto theirs = [&](LinkSet zero) {
      return row != rows.end() && (row->second.nowhere & zero) == 0 &&
             std::ranges::none_of(row->second.not_both,
                                  [&](LinkSet pair) { return (pair & ~zero) == 0; });
    };
    const LinkSet rest = certet::core::whole_link & ~plus;
    LinkSet zero = 0;
    do {
      differences.expect(is_disk(plus, zero) == theirs(zero), [&] {
        return "+ " + std::to_string(plus) + ", 0 " + std::to_string(zero);
      });
      zero = (zero - rest) & rest;
    } while (zero != 0);
  }
  return differences;
}

TEST(Conformance, OfAllLinks) { expect_none(disks(certet::core::is_strict_disk), 4782969); }

TEST(Conformance, CatchesALinkThatIsForgotten) {
  EXPECT_FALSE(disks([](LinkSet plus, LinkSet zero) {
                 return certet::core::is_strict_disk(plus, zero) && (plus != 0x2001 || zero != 0);
               }).empty());
}

// -- Patterns of materials ----------------------------------------------------------------

using Stencils = std::function<certet::MaterialStencil(const certet::CornerMaterials&)>;

certet::CornerMaterials corners_of(const std::string& pattern) {
  certet::CornerMaterials corners{};
  std::ranges::transform(pattern, corners.begin(),
                         [](char c) { return c == '0' ? certet::moved_corner : c - 'A'; });
  return corners;
}

Differences material_stencils(const Stencils& stencils) {
  Differences differences;
  for (const json& c : kit().at("material_stencils")) {
    const std::string pattern = c.at("corners");
    json tets = json::array();
    json mirrored = json::array();
    for (const auto& [vertices, owner] : stencils(corners_of(pattern))) {
      const auto& [p, q, r, s] = vertices;
      const std::string material(1, owner == certet::shared_owner ? 'Z' : pattern.at(owner));
      tets.push_back({material, name_of(p), name_of(q), name_of(r), name_of(s)});
      mirrored.push_back({material, name_of(p), name_of(q), name_of(s), name_of(r)});
    }
    expect(differences, pattern, {tets, mirrored}, {c.at("right_handed"), c.at("left_handed")});
  }
  return differences;
}

TEST(Conformance, OfMaterialStencils) {
  expect_none(material_stencils([](const auto& corners) { return certet::material_tets(corners); }),
              certet::material_pattern_count);
}

TEST(Conformance, CatchesAMutatedMaterialStencil) {
  for (const certet::CornerMaterials& pattern : certet::material_patterns) {
    if (certet::material_tets(pattern).count == 0) continue;
    EXPECT_FALSE(material_stencils([&](const certet::CornerMaterials& corners) {
                   certet::MaterialStencil stencil = certet::material_tets(corners);
                   if (certet::likeness(corners) == certet::likeness(pattern))
                     std::swap(stencil.tets[0].vertices[1], stencil.tets[0].vertices[2]);
                   return stencil;
                 }).empty());
  }
}

// -- Meshes -------------------------------------------------------------------------------

/// Points, sorted, and tetrahedra, each led by its material if there are several.
struct NumberedMesh {
  std::vector<Coord3> points;
  std::vector<std::vector<std::int64_t>> tets;
};

using Engine = std::function<NumberedMesh(const certet::Domain&, const Lattice&, Method)>;

NumberedMesh numbered_mesh(const certet::Mesh& mesh) {
  NumberedMesh numbered{{mesh.points.begin(), mesh.points.end()}, {}};
  std::ranges::sort(numbered.points);
  std::visit(
      [&](const auto& tets) {
        for (std::size_t n = 0; n < tets.size(); ++n) {
          auto& tet = numbered.tets.emplace_back();
          if (!mesh.labels.empty()) tet.push_back(mesh.labels[n]);
          for (const auto i : tets[n])
            tet.push_back(std::ranges::lower_bound(numbered.points, mesh.points[i]) -
                          numbered.points.begin());
        }
      },
      mesh.tets);
  return numbered;
}

NumberedMesh engine(const certet::Domain& domain, const Lattice& lattice, Method method) {
  return numbered_mesh(whole_mesh(domain, lattice, method, 2));
}

Lattice lattice_of(const json& c) {
  return {c.at("origin").get<Coord3>(), c.at("cells").get<std::array<std::int32_t, 3>>()};
}

/// An edge between two materials changes after the cut; those that the outermost points
/// have are not seen.
materials::Positional materials_of(const json& c) {
  std::map<Coord3, certet::Material> at;
  std::map<std::pair<Coord3, Coord3>, std::int32_t> cuts;
  const auto [origin, cells] = lattice_of(c);
  certet::Material most = 1;
  for (const int shift : {0, 1}) {
    const json& grid = c.at(shift == 0 ? "even" : "odd");
    for (int k = 1; k < cells[2] - 1; ++k)
      for (int j = 1; j < cells[1] - 1; ++j)
        for (int i = 1; i < cells[0] - 1; ++i) {
          const certet::Material m = grid.at(static_cast<std::size_t>(k))
                                         .at(static_cast<std::size_t>(j))
                                         .at(static_cast<std::size_t>(i));
          at[origin + 2 * Coord3{i, j, k} + Coord3{shift, shift, shift}] = m;
          most = std::max(most, m);
        }
  }
  for (const json& cut : c.at("cut"))
    cuts[{Coord3{cut[0], cut[1], cut[2]}, Coord3{cut[3], cut[4], cut[5]}}] =
        cut[6].get<std::int32_t>();
  std::vector<std::int32_t> labels;
  for (certet::Material m = 1; m <= most; ++m) labels.push_back(m);
  return {labels, [=](Coord3 p) -> certet::Material {
            const auto [a, b, t] = domains::edge_of(p);
            const auto material = [&](Coord3 v) {
              const auto found = at.find(v);
              return found == at.end() ? 0 : found->second;
            };
            if (const auto cut = cuts.find({a, b}); cut != cuts.end())
              return material(t <= cut->second ? a : b);
            if (const auto cut = cuts.find({b, a}); cut != cuts.end())
              return material(t > 0 && certet::steps - t <= cut->second ? b : a);
            return material(a);
          }};
}

/// Graded, in the kit's order: each tetrahedron with its least number first and the least of the
/// others second, and all of them sorted.
NumberedMesh graded_engine(const certet::Domain& domain, const Lattice& lattice, int levels) {
  certet::Context context;
  certet::Stuffing stuffing(domain, lattice, Method::embedded, context);
  certet::Grading grading;
  grading.levels = levels;
  stuffing.grade(grading, context);
  NumberedMesh numbered = numbered_mesh(certet::emit(stuffing, {}, context));
  for (auto& tet : numbered.tets) {
    const auto least = std::ranges::min_element(tet) - tet.begin();
    if (least > 1) std::rotate(tet.begin(), tet.begin() + 2, tet.end());
    if (least % 2 == 1) {
      std::swap(tet[0], tet[1]);
      std::swap(tet[2], tet[3]);
    }
    std::rotate(tet.begin() + 1, std::min_element(tet.begin() + 1, tet.end()), tet.end());
  }
  std::ranges::sort(numbered.tets);
  return numbered;
}

void compare(Differences& differences, const json& c, const NumberedMesh& mesh) {
  const std::string name = c.at("name");
  expect(differences, name + ", points", mesh.points, c.at("points"));
  expect(differences, name + ", tets", mesh.tets, c.at("tets"));
}

Differences settled(const Engine& production) {
  Differences differences;
  for (const json& c : kit().at("settled"))
    compare(differences, c, production(domain_of(c), lattice_of(c), Method::embedded));
  return differences;
}

Differences several_materials(const Engine& production) {
  Differences differences;
  for (const json& c : kit().at("materials"))
    compare(differences, c,
            production(materials_of(c), lattice_of(c),
                       c.at("cuts") == "midpoint" ? Method::midpoint : Method::embedded));
  return differences;
}

Differences graded(int by) {
  Differences differences;
  for (const json& c : kit().at("graded"))
    compare(differences, c,
            graded_engine(domain_of(c), lattice_of(c), c.at("levels").get<int>() + by));
  return differences;
}

TEST(Conformance, OfGradedMeshes) { expect_none(graded(0), 2 * 2); }
TEST(Conformance, CatchesALevelThatIsForgotten) { EXPECT_FALSE(graded(-1).empty()); }

TEST(Conformance, OfMeshesThatKeepTheShape) { expect_none(settled(engine), 2 * 13); }
TEST(Conformance, OfMeshesOfMaterials) { expect_none(several_materials(engine), 2 * 8); }

TEST(Conformance, CatchesTheRuleOfThePaper) {
  EXPECT_FALSE(settled([](const auto& domain, const Lattice& lattice, Method) {
                 return engine(domain, lattice, Method::angles);
               }).empty());
}

TEST(Conformance, CatchesAMaterialForAnother) {
  EXPECT_FALSE(several_materials([](const auto& domain, const Lattice& lattice, Method method) {
                 NumberedMesh mesh = engine(domain, lattice, method);
                 if (!mesh.tets.empty()) ++mesh.tets.back()[0];
                 return mesh;
               }).empty());
}

}  // namespace
