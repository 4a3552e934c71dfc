// The solid inside of a surface against its definition, and the defects of
// surfaces that were made to have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "../extents.hpp"
#include "../lattice_rows.hpp"
#include "../seed.hpp"
#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "surfaces.hpp"

namespace certet {
namespace {

using namespace surfaces;

/// The sign that a world point should have.
using Truth = std::function<Sign(const Point3&)>;

Sign of_box(const Point3& p, const Point3& low, const Point3& high) {
  double outer = -1e300;
  for (std::size_t a = 0; a < 3; ++a) outer = std::max({outer, low[a] - p[a], p[a] - high[a]});
  return sign_of_level(outer);
}

/// A planted bug: one lattice point of a row has a wrong sign.
struct Turned final : Domain {
  Turned(const Domain& domain, Coord3 wrong) : domain(domain), wrong(wrong) {}
  void row(Coord3 first, std::span<Sign> out) const override {
    domain.row(first, out);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (first + Coord3{2 * static_cast<int>(i), 0, 0} == wrong)
        out[i] = out[i] == Sign::plus ? Sign::minus : Sign::plus;
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    domain.at(positions, out);
  }
  const Domain& domain;
  Coord3 wrong;
};

/// Whether a sign will do: a point on an edge that goes inwards may count as
/// inside, since what is next to it on two opposite sides is.
bool will_do(Sign sign, Sign truth) {
  return sign == truth || (sign == Sign::plus && truth == Sign::on_surface);
}

/// Lattice points whose sign in a row is not the true one, or not that of `at`.
int differences(const Domain& domain, const PlacedDomain& place, const Truth& truth) {
  const Lattice& lattice = place.lattice();
  int found = 0;
  for_each_sign(domain, lattice, [&](Coord3 position, Sign in_row, Sign alone) {
    found += in_row != alone || (truth && !will_do(in_row, truth(place.frame().world(position))));
  });
  return found;
}

TEST(SurfaceDomain, BoxIsExact) {
  const Point3 low{-1, -1.5, -1}, high{1, 1.5, 1};
  const auto domain = surface_domain(box(low, high), {0.25, 2});
  const Truth truth = [&](const Point3& p) { return of_box(p, low, high); };
  EXPECT_EQ(differences(*domain, *domain, truth), 0);
  Sign face;  // a box has no edges that go inwards
  const Coord3 on_face{8 * steps, 0, 0};
  domain->at({&on_face, 1}, {&face, 1});
  EXPECT_EQ(face, Sign::on_surface);
  EXPECT_EQ(differences(Turned(*domain, {0, 0, 0}), *domain, truth), 1) << "planted bug";
}

TEST(SurfaceDomain, OverlappingBoxesAreUnited) {
  const Point3 low{-1, -1, -1}, high{1, 1, 1};
  const auto whole = both(box(low, {0.5, 0.5, 0.5}), box({-0.5, -0.5, -0.5}, high));
  const auto domain = surface_domain(whole, {0.25, 2});
  EXPECT_EQ(differences(*domain, *domain, [&](const Point3& p) {
              return std::max(of_box(p, low, {0.5, 0.5, 0.5}),
                              of_box(p, {-0.5, -0.5, -0.5}, high));
            }), 0);
}

TEST(SurfaceDomain, ShellWithinIsACavity) {
  const Point3 low{-1, -1, -1}, high{1, 1, 1}, in_low{-0.5, -0.5, -0.5}, in_high{0.5, 0.5, 0.5};
  const Truth truth = [&](const Point3& p) {
    const Sign inner = of_box(p, in_low, in_high);
    return inner == Sign::plus ? Sign::minus
                               : std::min(of_box(p, low, high),
                                          inner == Sign::on_surface ? inner : Sign::plus);
  };
  const auto cavity = both(box(low, high), inside_out(box(in_low, in_high)));
  const auto domain = surface_domain(cavity, {0.25, 2});
  EXPECT_EQ(differences(*domain, *domain, truth), 0);
  const auto turned = surface_domain(inside_out(cavity), {0.25, 2});
  EXPECT_EQ(differences(*turned, *turned, truth), 0);
}

TEST(SurfaceDomain, BallIsNearTheBall) {
  // Rows through poles and meridians meet corners and edges.
  const auto domain = surface_domain(ball({3, 4, 5}, 1), {0.1, 2});
  EXPECT_EQ(differences(*domain, *domain, {}), 0);
  const auto sign = [&](Coord3 p) {
    Sign s;
    domain->at({&p, 1}, {&s, 1});
    return s;
  };
  std::mt19937_64 random(test_seed());
  for (int n = 0; n < 20000; ++n) {
    const Coord3 p = 1024 * Coord3{between(random, -1500, 1500), between(random, -1500, 1500),
                                   between(random, -1500, 1500)};
    const Point3 w = domain->frame().world(p);
    const double r = std::hypot(w[0] - 3, w[1] - 4, w[2] - 5);
    if (r < 0.98 || r > 1.0001) {
      ASSERT_EQ(sign(p), r < 1 ? Sign::plus : Sign::minus) << r;
    }
  }
}

TEST(SurfaceDomain, RowsAgreeWithPointsForTurnedSurfaces) {
  const auto all = both(both(ball({0, 0, 0}, 1), ball({0.7, 0.1, 0}, 0.8, 9, 7)),
                        inside_out(ball({0.2, 0.3, 0.1}, 0.3, 7, 5)));
  const auto domain = surface_domain(all, {0.11, 3});
  EXPECT_EQ(differences(*domain, *domain, {}), 0);
}

TEST(SurfaceDomain, ExtentsHold) {
  const auto domain = surface_domain(ball({0, 0, 0}, 1), {0.01, 2});
  const extents::Known known = extents::known_blocks(*domain, domain->lattice());
  EXPECT_EQ(known.contradiction, "");
  EXPECT_GT(known.inside + known.outside, 500);
}

TEST(SurfaceDomain, DisagreeingTrianglesAreJudgedByParity) {
  auto surface = box({-1, -1, -1}, {1, 1, 1});
  std::swap(surface.triangles[3][0], surface.triangles[3][1]);
  EXPECT_EQ(inspect(surface).misoriented_edges.count, 3U);
  const auto domain = surface_domain(surface, {0.25, 2});
  EXPECT_EQ(differences(*domain, *domain, [](const Point3& p) {
              return of_box(p, {-1, -1, -1}, {1, 1, 1});
            }), 0);
}

void expect_refusal(const TriangleSurface& surface, ErrorCode code) {
  try {
    static_cast<void>(surface_domain(surface, {0.1, 2}));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
  }
}

TEST(SurfaceDomain, RefusesWhatIsNoSurface) {
  auto open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  expect_refusal(open, ErrorCode::bad_input);
  auto doubled = box({0, 0, 0}, {1, 1, 1});
  doubled.triangles.push_back(doubled.triangles[0]);
  expect_refusal(doubled, ErrorCode::bad_input);
  auto beyond = box({0, 0, 0}, {1, 1, 1});
  beyond.triangles[0][0] = 8;
  expect_refusal(beyond, ErrorCode::bad_input);
  auto nan = box({0, 0, 0}, {1, 1, 1});
  nan.points[3][1] = NAN;
  expect_refusal(nan, ErrorCode::bad_input);
  expect_refusal({"none", {}, {}}, ErrorCode::bad_input);
  expect_refusal(box({0, 0, 0}, {1, 1, 1e30}), ErrorCode::too_large);
}

TEST(Inspect, CountsEdges) {
  auto surface = box({0, 0, 0}, {1, 1, 1});
  const SurfaceDefects none = inspect(surface);
  EXPECT_EQ(none.open_edges.count + none.overfull_edges.count + none.misoriented_edges.count +
                none.self_intersections.count, 0U);
  EXPECT_FALSE(none.inside_out);
  EXPECT_TRUE(inspect(inside_out(surface)).inside_out);
  surface.triangles.push_back(surface.triangles[0]);
  const SurfaceDefects doubled = inspect(surface);
  EXPECT_EQ(doubled.open_edges.count, 0U);
  EXPECT_EQ(doubled.odd_edges.count, 3U);
  EXPECT_EQ(doubled.overfull_edges.count, 3U);
  EXPECT_FALSE(doubled.closed());
  surface = box({0, 0, 0}, {1, 1, 1});
  surface.triangles.erase(surface.triangles.begin());
  const SurfaceDefects open = inspect(surface);
  EXPECT_EQ(open.open_edges.count, 3U);
  EXPECT_EQ(open.open_edges.first, (Point3{0, 0, 0.5}));
  EXPECT_EQ(open.holes.count, 1U);
  EXPECT_EQ(open.holes.largest_edges, 3U);
  EXPECT_DOUBLE_EQ(open.holes.largest, std::sqrt(2));
}

TEST(Inspect, FindsSelfIntersections) {
  EXPECT_EQ(inspect(ball({0, 0, 0}, 1)).self_intersections.count, 0U);
  const auto apart = both(ball({0, 0, 0}, 1), ball({2.1, 0, 0}, 1));
  EXPECT_EQ(inspect(apart).self_intersections.count, 0U);
  const auto crossed = inspect(both(ball({0, 0, 0}, 1), ball({1.5, 0, 0}, 1)));
  EXPECT_GT(crossed.self_intersections.count, 10U);
  EXPECT_NEAR(crossed.self_intersections.first[0], 0.75, 0.01);
  // One spike through the opposite side.
  auto pierced = ball({0, 0, 0}, 1);
  pierced.points[20] = {0, 0, -2};
  EXPECT_GT(inspect(pierced).self_intersections.count, 0U);
  // Boxes that touch do not pass through each other.
  const auto touching = both(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(inspect(touching).self_intersections.count, 0U);
}

TEST(MergeEqualPoints, MakesSoupClosed) {
  const auto closed = ball({0, 0, 0}, 1);
  TriangleSurface soup{"soup", {{9, 9, 9}}, {}};
  for (const auto& t : closed.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t p : t) soup.points.push_back(closed.points[p]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_FALSE(inspect(soup).closed());
  merge_equal_points(soup);
  EXPECT_EQ(soup.points.size(), closed.points.size());
  EXPECT_TRUE(inspect(soup).closed());
}

}  // namespace
}  // namespace certet
