/// \file
/// Meshes of several solids: volumes and interfaces against the analytic ones, walls that
/// two solids share, who wins where they overlap, the same bytes whatever runs them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certet/check.hpp"
#include "certet/checksum.hpp"
#include "certet/placed_quality.hpp"
#include "solids.hpp"

namespace certet {
namespace {

using solids::Corners;
using solids::Measured;
using solids::measured;
using std::numbers::pi;

constexpr Method both_methods[] = {Method::embedded, Method::midpoint};

double ball_volume(double r) { return 4 * pi / 3 * r * r * r; }

/// The radius of a ball of triangles, so that it has the volume of a true one.
std::vector<NamedSolid> nested(bool surfaces) {
  const auto ball = [&](double r) {
    return surfaces ? solids::inside(surfaces::ball({0, 0, 0}, r, 160, 80)) : solids::ball(r);
  };
  return {{"outer", ball(1)}, {"middle", ball(0.7)}, {"inner", ball(0.4)}};
}

void expect_nested(const Measured& found, double share) {
  const auto near = [&](double value, double exact) {
    EXPECT_NEAR(value, exact, share * exact);
  };
  near(found.volumes.at(1), ball_volume(1) - ball_volume(0.7));
  near(found.volumes.at(2), ball_volume(0.7) - ball_volume(0.4));
  near(found.volumes.at(3), ball_volume(0.4));
  near(found.area_between(1, 2), 4 * pi * 0.49);
  near(found.area_between(2, 3), 4 * pi * 0.16);
  EXPECT_EQ(found.interfaces.size(), 2u);  // 1 and 3 do not touch
}

TEST(MaterialsMesh, NestedBallsHaveTheirVolumesAndInterfaces) {
  for (const bool surfaces : {false, true}) {
    const auto domain = materials_domain(nested(surfaces), {.size = 0.05});
    const Measured found = measured(*domain);
    expect_nested(found, 0.015);
    EXPECT_TRUE(check(found.mesh).failures.empty());
    EXPECT_EQ(standing_of(quality(found.mesh), bounds_of(found.mesh)), Standing::within);
    for (const auto& [labels, triangles] : found.interfaces)
      for (const Corners& triangle : triangles)
        for (const Point3& p : triangle)
          EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), labels[0] == 1 ? 0.7 : 0.4, 0.4 * 0.05);
  }
}

TEST(MaterialsMesh, TheOuterOneCoversTheOthersIfItIsStronger) {
  const auto domain = materials_domain(nested(false), {.size = 0.1}, {"outer"});
  const Measured found = measured(*domain);
  EXPECT_EQ(found.volumes.size(), 1u);
  EXPECT_NEAR(found.volumes.at(1), ball_volume(1), 0.02 * ball_volume(1));
  EXPECT_TRUE(found.interfaces.empty());
}

TEST(MaterialsMesh, MiddleOfThreeByPriority) {
  const Measured found =
      measured(*materials_domain(nested(false), {.size = 0.05}, {"inner", "outer"}));
  EXPECT_EQ(found.volumes.size(), 2u);
  EXPECT_NEAR(found.area_between(1, 3), 4 * pi * 0.16, 0.03);
  EXPECT_NEAR(found.volumes.at(1), ball_volume(1) - ball_volume(0.4), 0.05);
}

/// Of the area of a plane wall whose rim is so long.
double rim_error(double rim, double size) { return 0.5 * rim * size; }

/// Two boxes and the wall between them: at a plane of lattice points, and elsewhere.
struct Wall {
  double at;
  std::vector<std::string> priority;
};

std::vector<NamedSolid> boxes(double wall) {
  return {{"left", solids::block({-1, -0.5, -0.5}, {wall, 0.5, 0.5})},
          {"right", solids::block({wall, -0.5, -0.5}, {1, 0.5, 0.5})}};
}

/// Whether the boundary comes into the middle of the two boxes.
bool has_slit(const Measured& found) {
  return std::ranges::any_of(found.boundary, [](const Corners& triangle) {
    return std::ranges::all_of(triangle, [](const Point3& p) {
      return std::max({std::fabs(p[0]) - 0.5, std::fabs(p[1]), std::fabs(p[2])}) < 0.35;
    });
  });
}

/// A solid without its surface.
class Open final : public PlacedDomain {
 public:
  explicit Open(std::shared_ptr<const PlacedDomain> solid) : solid_(std::move(solid)) {}
  [[nodiscard]] const Frame& frame() const override { return solid_->frame(); }
  [[nodiscard]] const Lattice& lattice() const override { return solid_->lattice(); }
  [[nodiscard]] double longest_side() const override { return solid_->longest_side(); }
  void row(Coord3 first, std::span<Sign> out) const override {
    solid_->row(first, out);
    std::ranges::replace(out, Sign::on_surface, Sign::minus);
  }
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    solid_->at(positions, out);
    std::ranges::replace(out, Sign::on_surface, Sign::minus);
  }

 private:
  std::shared_ptr<const PlacedDomain> solid_;
};

/// If a wall on the lattice belonged to neither solid, the tests below would see it.
TEST(MaterialsMesh, AWallThatBelongsToNoneIsSeen) {
  std::vector<NamedSolid> open = boxes(0);
  for (NamedSolid& one : open)
    one.solid.on = [closed = one.solid.on](const PlacedLattice& around) {
      return std::make_shared<Open>(closed(around));
    };
  EXPECT_TRUE(has_slit(measured(*materials_domain(open, {.size = 0.125}))));
  EXPECT_FALSE(has_slit(measured(*materials_domain(boxes(0), {.size = 0.125}))));
}

/// A wall of two solids is one plane of faces, and nothing is between them.
TEST(MaterialsMesh, AWallThatTwoSolidsHaveIsOneInterface) {
  for (const Wall& wall : {Wall{0, {}}, Wall{0, {"left"}}, Wall{0.03, {}}, Wall{0.03, {"left"}},
                           Wall{-1. / 3, {}}, Wall{-1. / 3, {"left"}}}) {
    const auto domain = materials_domain(boxes(wall.at), {.size = 0.125}, wall.priority);
    const Measured found = measured(*domain);
    EXPECT_NEAR(found.volumes.at(1), 1 + wall.at, 0.02);
    EXPECT_NEAR(found.volumes.at(2), 1 - wall.at, 0.02);
    EXPECT_NEAR(found.volumes.at(1) + found.volumes.at(2), 2, 0.03);
    // Points that stay at the rim, where the outside is too, move cuts by up to 0.4 edges.
    EXPECT_NEAR(found.area_between(1, 2), 1, rim_error(4, 0.125));
    // Away from the rim no face leaves the plane by more than a few cuts are clamped by.
    double farthest = 0;
    for (const Corners& triangle : found.interfaces.at({1, 2}))
      for (const Point3& p : triangle)
        if (std::max(std::fabs(p[1]), std::fabs(p[2])) < 0.25)
          farthest = std::max(farthest, std::fabs(p[0] - wall.at));
    EXPECT_LT(farthest, 0.06 * 0.125) << wall.at << (wall.priority.empty() ? "" : " left");
    // A wall of lattice points is met exactly, whichever solid is the stronger.
    if (wall.at == 0) {
      EXPECT_EQ(farthest, 0) << (wall.priority.empty() ? "" : "left");
    }
    EXPECT_FALSE(has_slit(found));
    EXPECT_TRUE(check(found.mesh).failures.empty());
  }
}

/// With cuts in the middle too: no outside between two solids that touch.
TEST(MaterialsMesh, MidpointsLeaveNoGap) {
  for (const double wall : {0., 0.03}) {
    const Measured found = measured(*materials_domain(boxes(wall), {.size = 0.125}),
                                    Method::midpoint);
    EXPECT_NEAR(found.volumes.at(1) + found.volumes.at(2), 2, 0.5);
    EXPECT_GT(found.area_between(1, 2), 0.9);
    EXPECT_TRUE(check(found.mesh).failures.empty());
  }
}

/// By the paper's rule there are no interfaces: a label is that at the centre, and the wall
/// leaves no slit in the solid.
TEST(MaterialsMesh, ThePapersRuleTakesThemForOneSolid) {
  const Measured found = measured(*materials_domain(boxes(0), {.size = 0.125}), Method::angles);
  EXPECT_NEAR(found.volumes.at(1) + found.volumes.at(2), 2, 0.03);
  EXPECT_EQ(found.mesh.names.at(2), "right");
  EXPECT_FALSE(has_slit(found));
}

/// Three boxes that meet in the z axis: all three pairs have an interface of its area.
TEST(MaterialsMesh, ThreeMeetInACurve) {
  const std::vector<NamedSolid> three{{"half", solids::block({-1, -1, -1}, {0, 1, 1})},
                                      {"front", solids::block({0, -1, -1}, {1, 0, 1})},
                                      {"back", solids::block({0, 0, -1}, {1, 1, 1})}};
  for (const std::vector<std::string>& priority :
       {std::vector<std::string>{}, std::vector<std::string>{"front", "half"}}) {
    const Measured found = measured(*materials_domain(three, {.size = 0.11}, priority));
    for (const auto& [a, b] : {std::pair{1, 2}, std::pair{1, 3}, std::pair{2, 3}})
      EXPECT_NEAR(found.area_between(a, b), 2, rim_error(6, 0.11)) << a << b;
    EXPECT_NEAR(found.volumes.at(1), 4, 0.1);
    EXPECT_NEAR(found.volumes.at(2), 2, 0.07);
    EXPECT_NEAR(found.volumes.at(3), 2, 0.07);
    EXPECT_TRUE(check(found.mesh).failures.empty());
  }
}

/// Solids that are the same: the weaker one is nowhere, not even on the common surface.
TEST(MaterialsMesh, TheSameSolidTwiceIsTheStrongerOne) {
  const Solid same = solids::block({-1, -1, -1}, {1, 1, 1});
  for (const Method method : both_methods) {
    const Measured later = measured(*materials_domain({{"a", same}, {"b", same}}, {.size = 0.25}),
                                    method);
    EXPECT_EQ(later.volumes.size(), 1u);
    EXPECT_EQ(later.volumes.begin()->first, 2);
    const Measured earlier = measured(
        *materials_domain({{"a", same}, {"b", same}}, {.size = 0.25}, {"a"}), method);
    EXPECT_EQ(earlier.volumes.size(), 1u);
    EXPECT_EQ(earlier.volumes.begin()->first, 1);
  }
}

std::uint64_t checksum(const PlacedDomain& domain, int threads) {
  Context context;
  context.threads = threads;
  return checksum(mesh(domain, Method::embedded, context));
}

TEST(MaterialsMesh, ThreadsDoNotMatter) {
  const auto domain = materials_domain(nested(true), {.size = 0.08}, {"middle"});
  const std::uint64_t one = checksum(*domain, 1);
  for (const int threads : {2, 5, 8}) EXPECT_EQ(checksum(*domain, threads), one);
}

}  // namespace
}  // namespace certet
