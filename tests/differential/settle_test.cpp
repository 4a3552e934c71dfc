/// \file
/// The warp that keeps the shape, as the certificate has it: what is known of its links
/// and of meshes in which nothing is thin.

#include <gtest/gtest.h>

#include "certet/warp.hpp"
#include "certified.hpp"
#include "domains.hpp"

namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Sign;
using certified::Gap;
using certified::LinkSet;

constexpr int count = certet::direction_count;
constexpr certified::Thresholds angles{certet::angle_thresholds.long_edge,
                                       certet::angle_thresholds.short_edge};

/// All 3^14 links.
TEST(Settle, StrictDisksAreCounted) {
  std::size_t disks = 0;
  for (LinkSet plus = 0; plus < LinkSet{1} << count; ++plus)
    disks += certified::disks(plus).size();
  EXPECT_EQ(disks, 1159754U);
}

std::array<Sign, count> link_of(LinkSet plus, LinkSet zero) {
  std::array<Sign, count> link{};
  for (std::size_t d = 0; d < link.size(); ++d)
    link[d] = (plus >> d & 1) != 0   ? Sign::plus
              : (zero >> d & 1) != 0 ? Sign::on_surface
                                     : Sign::minus;
  return link;
}

TEST(Settle, OneLinkIsJudgedAsAmongAll) {
  for (LinkSet plus = 1; plus < LinkSet{1} << count; plus += 1023) {
    const std::vector<LinkSet> disks = certified::disks(plus);
    std::size_t next = 0;
    for (LinkSet zero = 0; zero < LinkSet{1} << count; ++zero) {
      if ((zero & plus) != 0) continue;
      const bool among = next < disks.size() && disks[next] == zero;
      next += among ? 1 : 0;
      if (zero % 7 == 0) {
        ASSERT_EQ(certified::is_disk(link_of(plus, zero)), among);
      }
    }
    EXPECT_EQ(next, disks.size());
  }
}

certified::Domain seen(const domains::Positional& domain) {
  return {[&](Coord3 v) { return domain.sign_at(certified::warped_position(v, {})); },
          [&](Coord3 plus, Coord3 minus) {
            return certified::bisect([&](std::int64_t t) {
              return domain.sign_at(certified::point_on_edge(plus, minus, t));
            });
          }};
}

/// Nobody stays, and few moves are shortened: nearly the paper's warp.
TEST(Settle, ASphereComesOutNearlyAsByThePaper) {
  const auto sphere = domains::of_level(domains::sphere(1.37, -2.81, 0.59, 5.3));
  const Lattice lattice{{-6, -10, -6}, {9, 9, 8}};
  const auto settled = certified::settle(angles, Gap::level, lattice, seen(sphere));
  const auto stuffed = certified::stuff(angles, lattice, seen(sphere));
  ASSERT_EQ(settled.size(), stuffed.size());
  std::size_t moved = 0;
  for (std::size_t n = 0; n < settled.size(); ++n) moved += settled[n] != stuffed[n] ? 1 : 0;
  EXPECT_LT(moved, settled.size() / 20);
}

/// The walls of a box a quarter away from lattice planes are flat; with a step left
/// between vertices they are not.
TEST(Settle, AWallHalfwayBetweenPlanesIsFlat) {
  const auto box = domains::of_level(domains::box(-3.5, 3.5));
  const Lattice lattice{{-6, -6, -6}, {7, 7, 7}};
  const auto off_the_wall = [&](Gap gap) {
    int off = 0;
    for (const auto& tet : certified::settle(angles, gap, lattice, seen(box)))
      for (const Coord3 p : tet) {
        const std::int32_t reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        off += reach > 3 * certet::steps && reach != 7 * certet::steps / 2;
      }
    return off;
  };
  EXPECT_EQ(off_the_wall(Gap::level), 0);
  EXPECT_GT(off_the_wall(Gap::strict), 0);
}

}  // namespace
