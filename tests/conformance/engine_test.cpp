/// \file
/// The engine passes the conformance kit; and the kit is read so that a bug
/// would be seen.

#include <gtest/gtest.h>

#include <map>

#include "certet/stuffing.hpp"
#include "engine_bisection.hpp"
#include "implementation.hpp"
#include "kit_cases.hpp"

namespace {

using namespace conformance;

certet::StructuredTetCase case_of(const std::string& name) {
  const auto at = std::ranges::find(certet::case_names, name);
  return static_cast<certet::StructuredTetCase>(at - certet::case_names.begin());
}

Differences lattice(const Implementation& production) {
  Differences differences;
  for (const json& c : kit().at("lattice")) {
    const certet::StructuredTetId id{c.at("anchor").get<Coord3>(), case_of(c.at("case"))};
    const certet::StructuredTet tet = production.structured_tet(id);
    json neighbors = json::array();
    for (const certet::FaceNeighbor& n : tet.neighbors) {
      json order = json::array();
      for (const int place : n.order) order.push_back(place + 1);
      neighbors.push_back(
          {{"anchor", n.id.anchor},
           {"case", certet::case_names[static_cast<std::size_t>(n.id.orientation)]},
           {"order", order}});
    }
    expect(differences, c.dump().substr(0, 40),
           {production.right_handed(id.orientation), tet.vertices, neighbors},
           {c.at("right_handed"), c.at("vertices"), c.at("neighbors")});
  }
  return differences;
}

Differences stencils(const Implementation& production) {
  Differences differences;
  for (const json& c : kit().at("stencils")) {
    json tets = json::array();
    json mirrored = json::array();
    for (const auto& [p, q, r, s] :
         production.unstructured_tets(signs_of<4>(c.at("signs")))) {
      tets.push_back({name_of(p), name_of(q), name_of(r), name_of(s)});
      mirrored.push_back({name_of(p), name_of(q), name_of(s), name_of(r)});
    }
    expect(differences, c.at("signs"), {tets, mirrored},
           {c.at("right_handed"), c.at("left_handed")});
  }
  return differences;
}

const std::map<std::string, certet::Thresholds> thresholds{
    {"angles", certet::angle_thresholds},
    {"embedding", certet::embedding_thresholds},
    {"midpoint", certet::no_warp_thresholds}};

Differences warp(const Implementation& production) {
  Differences differences;
  for (const json& c : kit().at("warp")) {
    const auto neighbors = signs_of<certet::direction_count>(c.at("neighbors"));
    const Sign sign = signs_of<1>(c.at("sign"))[0];
    const certet::Warping warping = production.warp(thresholds.at(c.at("thresholds")), sign,
                                                    neighbors, c.at("cuts").get<NeighborCuts>());
    const Sign after = warping.moves() ? Sign::on_surface : sign;
    json cuts_left = json::array();
    for (std::size_t d = 0; d < neighbors.size(); ++d)
      if (certet::opposite(after, neighbors[d])) cuts_left.push_back(d);
    Coord3 displacement{0, 0, 0};
    if (warping.moves())
      displacement = warping.distance *
                     certet::direction_offset[static_cast<std::size_t>(int{warping.direction})];
    expect(differences, c.dump(),
           {warping.direction, warping.distance, displacement,
            std::string(1, "-0+"[static_cast<int>(after)]), cuts_left},
           {c.at("direction"), c.at("distance"), c.at("displacement"), c.at("sign_after"),
            c.at("cuts_left")});
  }
  return differences;
}

Differences bisect() {
  Differences differences;
  int number = 0;
  for (const json& c : kit().at("bisect")) {
    std::map<std::int64_t, Sign> runs;
    for (const json& run : c.at("signs"))
      runs[run.at(0).get<std::int64_t>()] = signs_of<1>(run.at(1))[0];
    const auto sign = [&](std::int64_t t) { return std::prev(runs.upper_bound(t))->second; };
    const int direction = number % certet::direction_count;
    expect(differences, "bisect " + std::to_string(number++),
           engine_bisection::bisect(direction, sign), c.at("cut"));
  }
  return differences;
}

struct NamedMesh {
  std::uint64_t turned_over;
  std::string thresholds;
  std::vector<Coord3> points;  ///< sorted
  std::vector<std::array<std::size_t, 4>> tets;
};

using Engine = std::function<NamedMesh(const domains::Positional&, const Lattice&,
                                       certet::Method)>;

NamedMesh engine(const domains::Positional& domain, const Lattice& lattice,
                 certet::Method method) {
  certet::Context context;
  context.threads = 2;
  const certet::Stuffing stuffing(domain, lattice, method, context);
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  NamedMesh named{stuffing.inverted_tets(),
                  std::string(name(stuffing.method())),
                  {mesh.points.begin(), mesh.points.end()},
                  {}};
  std::ranges::sort(named.points);
  const auto number = [&](auto i) {
    const auto at = std::ranges::lower_bound(named.points, mesh.points[i]);
    return static_cast<std::size_t>(at - named.points.begin());
  };
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets)
          named.tets.push_back({number(a), number(b), number(c), number(d)});
      },
      mesh.tets);
  return named;
}

Differences meshes(const Engine& production) {
  Differences differences;
  for (const json& c : kit().at("meshes")) {
    const Lattice lattice{c.at("origin").get<Coord3>(),
                          c.at("cells").get<std::array<std::int32_t, 3>>()};
    const certet::Method method = c.at("cuts") == "midpoint"
                                      ? certet::Method::midpoint
                                      : certet::method_named(c.at("guarantee").get<std::string>()).value();
    const NamedMesh mesh = production(domain_of(c), lattice, method);
    const std::string name = c.at("name");
    expect(differences, name, {mesh.turned_over, mesh.thresholds},
           {c.at("turned_over"), c.at("thresholds")});
    expect(differences, name + ", points", mesh.points, c.at("points"));
    expect(differences, name + ", tets", mesh.tets, c.at("tets"));
  }
  return differences;
}

TEST(Conformance, OfTheConstants) {
  EXPECT_EQ(kit().at("certet_conformance"), 1);
  EXPECT_EQ(kit().at("steps"), certet::steps);
  EXPECT_EQ(kit().at("directions"), json(certet::direction_offset));
  for (const auto& [name, t] : thresholds)
    EXPECT_EQ(kit().at("thresholds").at(name), json({t.in_steps(0), t.in_steps(6)})) << name;
}

TEST(Conformance, OfTheLattice) { expect_none(lattice({}), 72); }
TEST(Conformance, OfTheStencils) { expect_none(stencils({}), 81); }
TEST(Conformance, OfBisection) { expect_none(bisect(), 150); }
TEST(Conformance, OfWarping) { expect_none(warp({}), 2000); }
TEST(Conformance, OfMeshes) { expect_none(meshes(engine), 3 * 20); }

TEST(Conformance, CatchesASwappedNeighbor) {
  Implementation broken;
  broken.structured_tet = [](const certet::StructuredTetId& id) {
    certet::StructuredTet tet = certet::structured_tet(id);
    std::swap(tet.neighbors[2], tet.neighbors[3]);
    return tet;
  };
  EXPECT_FALSE(lattice(broken).empty());
}

TEST(Conformance, CatchesAMutatedStencil) {
  for (int pattern = 0; pattern < certet::pattern_count; ++pattern) {
    if (certet::stencil_table[static_cast<std::size_t>(pattern)].count == 0) continue;
    Implementation broken;
    broken.unstructured_tets = [=](const certet::CornerSigns& signs) {
      certet::Stencil stencil = certet::unstructured_tets(signs);
      if (certet::pattern_index(signs) == pattern)
        std::swap(stencil.tets[0][1], stencil.tets[0][2]);
      return stencil;
    };
    EXPECT_FALSE(stencils(broken).empty()) << pattern;
  }
}

TEST(Conformance, CatchesAThresholdThatIsNotStrict) {
  Implementation broken;
  broken.warp = [](certet::Thresholds t, Sign sign, const NeighborSigns& neighbors,
                   NeighborCuts cuts) {
    certet::Warping warping = certet::warp(t, sign, neighbors, cuts);
    for (int d = 0; d < certet::direction_count && !warping.moves(); ++d) {
      const auto i = static_cast<std::size_t>(d);
      if (certet::opposite(sign, neighbors[i]) && cuts[i] == t.in_steps(d))
        warping = {static_cast<std::int8_t>(d), cuts[i]};
    }
    return warping;
  };
  EXPECT_FALSE(warp(broken).empty());
}

TEST(Conformance, CatchesAnEngineThatNeverFallsBack) {
  EXPECT_FALSE(meshes([](const auto& domain, const Lattice& lattice, auto options) {
                 NamedMesh mesh = engine(domain, lattice, options);
                 mesh.turned_over = 0;
                 return mesh;
               }).empty());
}

TEST(Conformance, CatchesOneStepOfOnePoint) {
  EXPECT_FALSE(meshes([](const auto& domain, const Lattice& lattice, auto options) {
                 NamedMesh mesh = engine(domain, lattice, options);
                 if (!mesh.points.empty()) ++mesh.points.back().z;
                 return mesh;
               }).empty());
}

}  // namespace
