// Surfaces with defects against the surface that they were made of: closed, with its
// volume, and the same signs on a lattice.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "../lattice_rows.hpp"
#include "../seed.hpp"
#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "surfaces.hpp"

namespace certet {
namespace {

using namespace surfaces;

/// Lattice points whose signs differ; both solids have the same box.
int differences(const TriangleSurface& one, const TriangleSurface& other, double size) {
  const auto a = open_surface_domain(one, {size, 2}), b = open_surface_domain(other, {size, 2});
  const Lattice& lattice = a->lattice();
  int found = 0;
  std::vector<Sign> of_a(static_cast<std::size_t>(lattice.cells[0])), of_b(of_a);
  for_each_row(lattice, [&](Coord3 first) {
    a->row(first, of_a);
    b->row(first, of_b);
    for (std::size_t i = 0; i < of_a.size(); ++i) found += of_a[i] != of_b[i];
  });
  return found;
}

TriangleSurface soup(const TriangleSurface& surface) {
  TriangleSurface result{"soup", {}, {}};
  for (const auto& t : surface.triangles) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t p : t) result.points.push_back(surface.points[p]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(Repair, LeavesCleanSurfacesAsTheyAre) {
  const auto whole = both(ball({0, 0, 0}, 1), inside_out(ball({0, 0, 0}, 0.5)));
  auto surface = whole;
  EXPECT_TRUE(sentences_on(repair_surface(surface)).empty());
  EXPECT_EQ(surface.points, whole.points);
  EXPECT_EQ(surface.triangles, whole.triangles);
}

/// Several defects at once, at random; the solid is the same.
TEST(Repair, GivesTheSolidBack) {
  const auto whole = ball({0.2, -0.1, 0.3}, 1);
  std::mt19937_64 random(test_seed());
  const double volume = measure(whole).volume;
  for (int n = 0; n < 10; ++n) {
    auto surface = whole;
    const auto any = [&] {
      return static_cast<std::size_t>(between(random, 0, static_cast<int>(whole.triangles.size()) - 1));
    };
    auto& turned = surface.triangles[any()];
    std::swap(turned[0], turned[1]);
    auto& cut = surface.triangles[any()];
    const auto corner = static_cast<std::uint32_t>(surface.points.size());
    Point3 middle;
    for (std::size_t a = 0; a < 3; ++a)
      middle[a] = 0.7 * surface.points[cut[0]][a] + 0.3 * surface.points[cut[1]][a];
    surface.points.push_back(middle);
    const std::array<std::uint32_t, 3> rest{corner, cut[1], cut[2]};
    cut[1] = corner;
    surface.triangles.push_back(rest);
    surface.triangles.push_back(surface.triangles[any()]);
    surface = soup(surface);
    for (Point3& p : surface.points)
      for (double& c : p) c += 1e-9 * between(random, -100, 100);
    const SurfaceRepairs repairs = repair_surface(surface);
    ASSERT_TRUE(is_closed(surface));
    EXPECT_GT(repairs.welded_points, 0U);
    EXPECT_LT(repairs.tolerance, 1e-5);
    EXPECT_NEAR(measure(surface).volume, volume, 1e-5);
    EXPECT_EQ(inspect(surface).misoriented_edges.count, 0U);
  }
}

TEST(Repair, ClosesAFlatHoleWhereItWas) {
  auto surface = box({-1, -1, -1}, {1, 1, 1});
  surface.triangles.erase(surface.triangles.begin() + 4);
  EXPECT_FALSE(is_closed(surface));
  EXPECT_EQ(repair_surface(surface).closed_holes.count, 0U);
  EXPECT_THROW(refuse_open(surface, inspect(surface), "there is a remedy"), Error);
  const SurfaceRepairs repairs = repair_surface(surface, {true});
  EXPECT_EQ(repairs.closed_holes.count, 1U);
  EXPECT_DOUBLE_EQ(repairs.closed_holes.largest, std::sqrt(8.0));
  const auto whole = box({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(differences(surface, whole, 0.25), 0);
  const auto hollow = both(whole, inside_out(box({-0.6, -0.6, -0.6}, {-0.4, -0.4, -0.4})));
  EXPECT_GT(differences(surface, hollow, 0.25), 0) << "planted bug";
}

/// A ball without its northern part is closed there by a flat lid.
TEST(Repair, ClosesLargeHoles) {
  for (const std::uint32_t around : {20U, 100U, 500U}) {
    auto surface = ball({0, 0, 0}, 1, around, 20);
    std::erase_if(surface.triangles, [&](const auto& t) {
      return std::all_of(t.begin(), t.end(),
                         [&](std::uint32_t p) { return surface.points[p][2] > 0.45; });
    });
    auto lid = surface;
    const double height = std::cos(std::acos(-1.0) * 7 / 20);  // of the last ring
    const auto top = static_cast<std::uint32_t>(lid.points.size());
    lid.points.push_back({0, 0, height});
    const std::uint32_t ring = 6 * around;
    for (std::uint32_t i = 0; i < around; ++i)
      lid.triangles.push_back({top, ring + i, ring + (i + 1) % around});
    ASSERT_TRUE(is_closed(lid));
    const SurfaceRepairs repairs = repair_surface(surface, {true});
    EXPECT_EQ(repairs.closed_holes.count, 1U);
    EXPECT_EQ(repairs.closed_holes.largest_edges, around);
    EXPECT_EQ(differences(surface, lid, 0.09), 0);
  }
}

TEST(Repair, WallsStoredOnceAreWithinTheUnion) {
  auto surface = both(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
  merge_equal_points(surface);
  // The two triangles of the wall that face the other way.
  std::erase_if(surface.triangles, [&, seen = 0](const auto& t) mutable {
    const bool wall = std::all_of(t.begin(), t.end(),
                                  [&](std::uint32_t p) { return surface.points[p][0] == 1; });
    return wall && ++seen > 2;
  });
  EXPECT_GT(inspect(surface).odd_edges.count, 0U);
  EXPECT_EQ(inspect(surface).open_edges.count, 0U);
  EXPECT_EQ(repair_surface(surface).inner_triangles, 2U);
  EXPECT_EQ(differences(surface, box({0, 0, 0}, {2, 1, 1}), 0.125), 0);
}

TEST(Measure, KnowsVolumeAndThickness) {
  const auto plate = box({0, 0, 0}, {1, 1, 0.01});
  const SurfaceMeasures measures = measure(plate);
  EXPECT_NEAR(measures.volume, 0.01, 1e-12);
  EXPECT_NEAR(measures.area, 2.04, 1e-12);
  EXPECT_NEAR(measures.thin, 0.01, 1e-6);
  EXPECT_NEAR(default_size(plate, measures).wanted, 0.0025, 1e-6);
  EXPECT_TRUE(default_size(plate, measures).limited());
  const auto twice = both(box({0, 0, 0}, {1, 1, 1}), box({0.5, 0, 0}, {1.5, 1, 1}));
  EXPECT_NEAR(measure(twice).volume, 1.5, 0.02);
  const auto thick = box({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(default_size(thick, measure(thick)).size, 3.0 / 64);
}

}  // namespace
}  // namespace certet
