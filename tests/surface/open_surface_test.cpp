// The solid of a surface with holes against the definition: triangle by triangle, the
// solid angles that they cover, as a part of the sphere.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <random>

#include "../extents.hpp"
#include "../lattice_rows.hpp"
#include "../seed.hpp"
#include "arc.hpp"
#include "certet/error.hpp"
#include "certet/surface.hpp"
#include "rims.hpp"
#include "steady_rest.hpp"
#include "surfaces.hpp"

namespace certet {
namespace {

using namespace surfaces;

const double pi = std::acos(-1.0);

/// Van Oosterom and Strackee's formula.
double solid_angle(const std::array<Point3, 3>& t, const Point3& from) {
  std::array<Point3, 3> v;
  std::array<double, 3> far;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < 3; ++a) v[i][a] = t[i][a] - from[a];
    far[i] = std::sqrt(dot(v[i], v[i]));
  }
  return 2 * std::atan2(dot(v[0], cross(v[1], v[2])),
                        far[0] * far[1] * far[2] + dot(v[0], v[1]) * far[2] +
                            dot(v[1], v[2]) * far[0] + dot(v[2], v[0]) * far[1]);
}

/// By the definition.  `planted` triangles count with the wrong sign.
double winding_number(const TriangleSurface& surface, const Point3& from, std::size_t planted = 0) {
  double sum = 0;
  for (std::size_t n = 0; n < surface.triangles.size(); ++n) {
    const auto& [a, b, c] = surface.triangles[n];
    const double angle =
        solid_angle({surface.points[a], surface.points[b], surface.points[c]}, from);
    sum += n < planted ? -angle : angle;
  }
  return sum / (4 * pi);
}

TriangleSurface without(TriangleSurface surface,
                        const std::function<bool(const Point3&)>& gone) {
  std::erase_if(surface.triangles, [&](const auto& t) {
    Point3 centre{0, 0, 0};
    for (const std::uint32_t p : t)
      for (std::size_t a = 0; a < 3; ++a) centre[a] += surface.points[p][a] / 3;
    return gone(centre);
  });
  return surface;
}

/// All triangles apart, and smaller.
TriangleSurface soup(const TriangleSurface& surface, double share) {
  TriangleSurface result{"soup", {}, {}};
  for (const auto& t : surface.triangles) {
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (const std::uint32_t p : t) {
      Point3& corner = result.points.emplace_back();
      for (std::size_t a = 0; a < 3; ++a) {
        const double centre = (surface.points[t[0]][a] + surface.points[t[1]][a] +
                               surface.points[t[2]][a]) / 3;
        corner[a] = centre + share * (surface.points[p][a] - centre);
      }
    }
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

struct Signs {
  int wrong = 0;    ///< against the definition, where that is not near to one half
  int unequal = 0;  ///< of a row and of single points
  int inside = 0;
};

Signs compare(const PlacedDomain& domain, const TriangleSurface& surface, double near = 0.005,
              std::size_t planted = 0) {
  const Lattice& lattice = domain.lattice();
  Signs found;
  for_each_sign(domain, lattice, [&](Coord3 position, Sign in_row, Sign alone) {
    found.unequal += alone != in_row;
    found.inside += alone == Sign::plus;
    if (alone == Sign::on_surface) return;
    const double w = std::fabs(winding_number(surface, domain.frame().world(position), planted));
    found.wrong += std::fabs(w - 0.5) > near && (w > 0.5) != (alone == Sign::plus);
  });
  return found;
}

TEST(Arc, IsTheArctangent) {
  for (int n = -1000; n <= 1000; ++n) {
    const double angle = pi * n / 1000;
    EXPECT_NEAR(angle_in_turns(3 * std::sin(angle), 3 * std::cos(angle)), n / 2000.0, 1e-14);
  }
  EXPECT_EQ(angle_in_turns(0, 0), 0);
}

/// Sums, products and square roots alone, in a fixed order: all compilers and machines
/// make the same bits of them.
TEST(Rims, HaveTheSameNumbersEverywhere) {
  std::mt19937 random(5);
  const auto any = [&] { return static_cast<std::int32_t>(random() % (1U << 22)) - (1 << 21); };
  std::vector<RimLoop> loops;
  for (int n = 0; n < 3000; ++n) {
    const Coord3 middle{any(), any(), any()};
    RimLoop& loop = loops.emplace_back();
    const auto points = 3 + random() % 20;
    for (std::uint32_t p = 0; p < points; ++p)
      loop.push_back(middle + Coord3{any() >> 5, any() >> 5, any() >> 5});
    loop.push_back(loop.front());
  }
  const Rims rims(loops);
  std::uint64_t hash = 1469598103934665603U;
  const auto add = [&](double number) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211U;
  };
  for (int n = 0; n < 20000; ++n) {
    const Coord3 p{any(), any(), any()};
    add(rims.rest(p, n % 2 != 0 ? exact::Nudge::forward : exact::Nudge::backward));
    add(rims.variation(p, 1000 + n, 0.4));
  }
  EXPECT_EQ(hash, 0xf4d0441850d0a57cU);
}

/// Where it is told at once which whole number the rest is near to, it is; and it is told of
/// most points, but of none at a rim or where a ray may pass one.
TEST(SteadyRest, IsTheWholeNumberNearTheRest) {
  std::mt19937_64 random(test_seed());
  constexpr std::int32_t reach = 1 << 24;
  const auto any = [&] { return ::between(random, -reach, reach); };
  std::vector<RimLoop> loops;
  for (int n = 0; n < 12; ++n) {
    const Coord3 middle{any() / 2, any() / 2, any() / 2};
    RimLoop& loop = loops.emplace_back();
    for (int p = 0; p < 10; ++p) loop.push_back(middle + Coord3{any() / 16, any() / 16, any() / 16});
    loop.push_back(loop.front());
  }
  const Rims rims(loops);
  const SteadyRest steady(rims, {{-reach, -reach, -reach}, {reach, reach, reach}});
  int told = 0, shifted = 0;
  for (int n = 0; n < 40000; ++n) {
    const Coord3 p{any(), any(), any()};
    const std::optional<int> whole = steady.whole(p);
    if (!whole) continue;
    ++told;
    for (const exact::Nudge nudge : {exact::Nudge::forward, exact::Nudge::backward})
      ASSERT_LT(std::fabs(rims.rest(p, nudge) - *whole), 0.5 - lost_far_away / 2);
    shifted += std::fabs(rims.rest(p, exact::Nudge::forward) - (*whole + 1)) > 0.5;
  }
  EXPECT_GT(told, 20000);
  EXPECT_EQ(shifted, told);  // another number would not go unnoticed
  for (const RimLoop& loop : loops)
    for (const Coord3 p : loop) {
      EXPECT_FALSE(steady.whole(p));
      EXPECT_FALSE(steady.whole({p.x - (1 << 20), p.y, p.z}));
    }
  EXPECT_FALSE(steady.whole({reach + 1, 0, 0}) && steady.whole({reach + (1 << 20), 0, 0}));
}

/// Rows run through corners and edges of the rims.
TEST(OpenSurface, BoxWithoutAFaceOrATriangle) {
  const auto whole = box({-1, -1, -1}, {1, 1, 1});
  const auto of_whole = surface_domain(whole, {0.25, 2});
  for (std::size_t n = 0; n < 12; ++n)
    for (const std::ptrdiff_t count : {1, 2}) {
      if (n % 2 != 0 && count == 2) continue;
      auto surface = whole;
      const auto at = surface.triangles.begin() + static_cast<std::ptrdiff_t>(n);
      surface.triangles.erase(at, at + count);
      const auto domain = open_surface_domain(surface, {0.25, 2});
      const Signs signs = compare(*domain, surface);
      EXPECT_EQ(signs.wrong, 0);
      EXPECT_EQ(signs.unequal, 0);
      // The plane of the face closes it: its points are on the surface.
      EXPECT_EQ(signs.inside, compare(*of_whole, whole).inside);
    }
}

TEST(OpenSurface, IsWhatTheDefinitionSays) {
  const auto sphere = ball({0.1, 0.2, 0.3}, 1, 30, 15);
  std::mt19937_64 random(test_seed());
  const auto rarely = [&](const Point3&) { return ::between(random, 0, 9) == 0; };
  const std::vector<TriangleSurface> surfaces{
      without(sphere, [](const Point3& p) { return p[2] > 0.9; }),
      without(sphere, [](const Point3& p) { return p[0] > 0.1; }),
      without(sphere, rarely),
      both(without(sphere, rarely), without(ball({0.8, 0, 0}, 0.7, 20, 10), rarely)),
      both(without(sphere, rarely), inside_out(without(ball({0, 0, 0}, 0.6, 20, 10), rarely))),
      inside_out(without(sphere, rarely)),
      soup(sphere, 0.99),
      soup(box({-1, -1, -1}, {1, 1, 1}), 0.99),
      soup(both(sphere, box({-2, -0.2, -0.2}, {2, 0.2, 0.2})), 0.9)};
  for (const TriangleSurface& surface : surfaces) {
    const auto domain = open_surface_domain(surface, {0.22, 2});
    const Signs signs = compare(*domain, surface);
    EXPECT_EQ(signs.wrong, 0);
    EXPECT_EQ(signs.unequal, 0);
    EXPECT_GT(signs.inside, 50);
    EXPECT_GT(compare(*domain, surface, 0.005, surface.triangles.size() / 4).wrong, 0)
        << "planted bug";
  }
}

TEST(OpenSurface, ExtentsHold) {
  const auto holes = without(ball({0, 0, 0}, 1), [](const Point3& p) { return p[2] > 0.8; });
  for (const TriangleSurface& surface : {holes, soup(ball({0, 0, 0}, 1), 0.99)}) {
    const auto domain = open_surface_domain(surface, {0.005, 2});
    const extents::Known known = extents::known_blocks(*domain, domain->lattice());
    EXPECT_EQ(known.contradiction, "");
    EXPECT_GT(known.inside, 100);
    EXPECT_GT(known.outside, 100);
  }
}

TEST(OpenSurface, AClosedOneIsAsAlways) {
  const auto surface = both(ball({0, 0, 0}, 1), inside_out(ball({0, 0, 0}, 0.5)));
  const auto one = surface_domain(surface, {0.1, 2}), other = open_surface_domain(surface, {0.1, 2});
  const Lattice& lattice = one->lattice();
  std::vector<Sign> of_one(static_cast<std::size_t>(lattice.cells[0])), of_other(of_one);
  for (int k = 0; k < 2 * lattice.cells[2]; k += 2)
    for (int j = 0; j < 2 * lattice.cells[1]; j += 2) {
      one->row(lattice.origin + Coord3{0, j, k}, of_one);
      other->row(lattice.origin + Coord3{0, j, k}, of_other);
      ASSERT_EQ(of_one, of_other);
    }
}

TEST(OpenSurface, RefusesWhatWindsAroundNothing) {
  auto sheet = without(box({0, 0, 0}, {1, 1, 1}), [](const Point3& p) { return p[2] > 0; });
  EXPECT_THROW(refuse_unclear(sheet), Error);
  const auto cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_NO_THROW(refuse_unclear(soup(cube, 0.99)));
  EXPECT_NO_THROW(refuse_unclear(inside_out(soup(cube, 0.99))));
  auto anyhow = soup(ball({0, 0, 0}, 1), 0.99);
  for (std::size_t n = 0; n < anyhow.triangles.size(); n += 2)
    std::swap(anyhow.triangles[n][0], anyhow.triangles[n][1]);
  EXPECT_THROW(refuse_unclear(anyhow), Error);
  auto some = soup(ball({0, 0, 0}, 1), 0.99);
  for (std::size_t n = 0; n < some.triangles.size(); n += 10)
    std::swap(some.triangles[n][0], some.triangles[n][1]);
  EXPECT_THROW(refuse_unclear(some), Error);
}

/// Triangles all apart, of which some face the other way than the rest.
TEST(OpenSurface, PiecesAreTurnedAsTheOthersFace) {
  for (const auto& whole : {ball({0, 0, 0}, 1, 16, 8), box({-1, -1, -1}, {1, 1, 1})}) {
    const auto right = soup(whole, 0.98);
    auto surface = right;
    std::uint64_t turned = 0;
    for (std::size_t n = 0; n < surface.triangles.size(); n += 5, ++turned)
      std::swap(surface.triangles[n][1], surface.triangles[n][2]);
    const SurfaceRepairs repairs = repair_surface(surface, {true});
    EXPECT_EQ(repairs.turned_triangles, turned);
    EXPECT_NO_THROW(refuse_unclear(surface));
    std::size_t differ = 0;
    for (std::size_t n = 0; n < surface.triangles.size(); ++n) {
      for (std::size_t i = 0; i < 3; ++i)
        differ += surface.points[surface.triangles[n][i]] != right.points[right.triangles[n][i]];
    }
    EXPECT_EQ(differ, 0U);
  }
}

/// A strip with one side: nothing says which way its triangles should face.
TEST(OpenSurface, MoebiusStripIsRefused) {
  TriangleSurface strip{"strip", {}, {}};
  constexpr std::uint32_t count = 24;
  for (std::uint32_t n = 0; n < count; ++n)
    for (const double side : {-0.3, 0.3}) {
      const double around = 2 * pi * n / count, out = 1 + side * std::cos(around / 2);
      strip.points.push_back({out * std::cos(around), out * std::sin(around),
                              side * std::sin(around / 2)});
    }
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::uint32_t a = 2 * n, b = a + 1;
    const std::uint32_t c = n + 1 < count ? a + 2 : 1, d = n + 1 < count ? b + 2 : 0;
    strip.triangles.push_back({a, c, d});
    strip.triangles.push_back({a, d, b});
  }
  static_cast<void>(repair_surface(strip, {true}));
  EXPECT_THROW(open_surface_domain(strip, {0.1, 2}), Error);
}

}  // namespace
}  // namespace certet
