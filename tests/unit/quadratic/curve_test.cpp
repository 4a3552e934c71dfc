// Middle nodes on the surface of a ball.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "certet/bounded_function.hpp"
#include "certet/curve.hpp"
#include "certet/curved_quality.hpp"
#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/materials_domain.hpp"
#include "certet/write_mesh.hpp"
#include "format/sample_mesh.hpp"
#include "format/scratch_folder.hpp"

namespace certet {
namespace {

const PlacedDomain& ball() {
  static const BoundedFunction domain(
      [](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
      {{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}, 0.25);
  return domain;
}

double volume_of(const Mesh& mesh, const MiddleNodes& middles) {
  const Buffer<Point3> points = world_points(mesh);
  const std::vector<Point3> nodes = middle_points(mesh, middles);
  std::vector<Tet<std::uint64_t>> tets;
  std::vector<std::array<std::uint64_t, 6>> numbers;
  std::visit(
      [&](const auto& all) {
        for (const auto& tet : all) {
          tets.push_back({tet[0], tet[1], tet[2], tet[3]});
          numbers.push_back(middles.of(tet));
        }
      },
      mesh.tets);
  Context context;
  const CurvedQuality found = measure_curved(points, tets, nodes, numbers, context);
  EXPECT_TRUE(found.failures.empty());
  return found.volume;
}

TEST(Curve, TheVolumeOfABallIsNearerByAnOrder) {
  Context context;
  const Mesh made = mesh(ball());
  MiddleNodes middles = middle_nodes(made);
  const double exact = 4 * std::acos(-1.0) / 3;
  const double straight = std::fabs(volume_of(made, middles) / exact - 1);
  const CurveFigures figures = curve(middles, made, survey(made, context), ball(), context);
  const double curved = std::fabs(volume_of(made, middles) / exact - 1);
  std::cout << "relative error of the volume: " << straight << " straight, " << curved
            << " curved; " << figures.moved << " of " << figures.edges << " moved, "
            << figures.guarded << " guarded, " << figures.far << " far; Jacobian at least "
            << figures.least_jacobian << '\n';
  EXPECT_LT(curved, straight / 10);
  EXPECT_EQ(figures.edges, figures.moved + figures.on_surface + figures.guarded + figures.far +
                               figures.seams);
  EXPECT_GE(figures.least_jacobian, 1.0 / least_jacobian_divisor);
  EXPECT_EQ(middles.bends().size(), figures.moved);
}

/// Whatever the order of the labels: the stronger of two balls is the second, or the first.  Where
/// three materials meet, an edge is bent onto one surface or another by the order.
TEST(Curve, LabelsMayBeInAnyOrder) {
  const auto ball_at = [](double x) {
    return function_solid([x](Point3 p) { return std::hypot(p[0] - x, p[1], p[2]) - 1; },
                          Bounds{{x - 1.1, -1.1, -1.1}, {x + 1.1, 1.1, 1.1}});
  };
  const auto figures_of = [](const PlacedDomain& domain) {
    Context context;
    const Mesh made = mesh(domain);
    MiddleNodes middles = middle_nodes(made);
    return curve(middles, made, survey(made, context), domain, context);
  };
  const NamedSolid weak{"weak", ball_at(0)}, strong{"strong", ball_at(0.9)};
  const CurveFigures last = figures_of(*materials_domain({weak, strong}, {.size = 0.2}));
  const CurveFigures first = figures_of(*materials_domain({strong, weak}, {.size = 0.2}, {"strong"}));
  for (const CurveFigures& figures : {last, first}) {
    EXPECT_GT(figures.moved, 1000u);
    EXPECT_LT(figures.far, figures.moved / 20);
    EXPECT_EQ(figures.edges, last.edges);
  }
}

/// Where bounds cut a ball off, the flat side stays flat; the straight mesh has not all of the rim
/// itself, so that some edges there are far from the surface.
TEST(Curve, ARimStaysInItsPlane) {
  const BoundedFunction half([](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
                             {{-1.2, -1.2, 0}, {1.2, 1.2, 1.2}}, 0.2);
  Context context;
  const Mesh made = mesh(half);
  MiddleNodes middles = middle_nodes(made);
  const double exact = 2 * std::acos(-1.0) / 3;
  const double straight = std::fabs(volume_of(made, middles) / exact - 1);
  const CurveFigures figures = curve(middles, made, half);
  const double curved = std::fabs(volume_of(made, middles) / exact - 1);
  std::cout << "half a ball: " << straight << " straight, " << curved << " curved; "
            << figures.moved << " of " << figures.edges << " moved, " << figures.guarded
            << " guarded, " << figures.far << " far, " << figures.seams << " seams\n";
  EXPECT_EQ(figures.seams, 0u);
  EXPECT_LT(curved, straight / 2);
  EXPECT_LT(figures.far, figures.edges / 10);
  for (const Point3& node : middle_points(made, middles)) EXPECT_GT(node[2], -1e-4);
}

TEST(Curve, ACountedMeshGivesTheSameForAnyNumberOfThreads) {
  Context context;
  const Mesh made = mesh(ball());
  MiddleNodes expected = middle_nodes(made);
  curve(expected, made, survey(made, context), ball(), context);
  const Stuffing stuffing(ball(), ball().lattice(), default_method, context);
  for (const int threads : {1, 4}) {
    Context own;
    own.threads = threads;
    MiddleNodes found = middle_nodes(stuffing, own);
    curve(found, stuffing, survey(stuffing, own), ball(), own);
    EXPECT_TRUE(std::ranges::equal(found.bends(), expected.bends()));
  }
}

/// A file that is written slab by slab, of as few layers as can be or all at once, is that of the
/// mesh in memory.
TEST(Curve, SlabsGiveTheBytesOfTheWhole) {
  const test::ScratchFolder folder;
  Context context;
  const Mesh made = mesh(ball());
  MiddleNodes nodes = middle_nodes(made);
  curve(nodes, made, survey(made, context), ball(), context);
  const Stuffing stuffing(ball(), ball().lattice(), default_method, context);
  for (const char* name : {"a.vtu", "a.msh", "a.inp"}) {
    write(made, nodes, folder / name);
    const std::string expected = test::bytes_of(folder / name);
    MeshSize size{stuffing.point_count() + nodes.count(), stuffing.tet_count(), false};
    size.survey = std::make_shared<const Survey>(survey(made, context));
    size.middles = std::make_shared<const MiddleNodes>(nodes);
    for (const std::uint64_t bytes : {std::uint64_t{0}, std::uint64_t{1} << 30}) {
      const auto writer = open_writer(folder / name, *format_of(name), size);
      write_mesh(stuffing, ball().frame(), cut_slabs(stuffing, bytes), *writer, context, {}, false,
                 &nodes);
      writer->finish();
      EXPECT_TRUE(test::bytes_of(folder / name) == expected) << name;
    }
  }
}

TEST(Curve, StepsAreNoSurfaceToBeOn) {
  Context context;
  const Mesh made = mesh(ball(), Method::midpoint);
  MiddleNodes middles = middle_nodes(made);
  EXPECT_THROW(curve(middles, made, survey(made, context), ball(), context), Error);
}

}  // namespace
}  // namespace certet
