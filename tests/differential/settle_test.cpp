/// \file
/// The warp that keeps the shape: every link that can occur, and what is known of meshes.
/// Whole meshes of the engine are compared in mesh_test.cpp; here the model of the property
/// tests is, and with one thing forgotten it must differ.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "certet/lattice/warp.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "domains.hpp"
#include "engine/link.hpp"
#include "property/settling_model.hpp"
#include "seed.hpp"

namespace {

using certet::Coord3;
using certet::Lattice;
using certet::Sign;
using certified::Gap;
using certified::LinkSet;

constexpr int count = certet::direction_count;
constexpr certified::Thresholds angles{certet::angle_thresholds.long_edge,
                                       certet::angle_thresholds.short_edge};

constexpr LinkSet all_sets = LinkSet{1} << count;

/// The production side: whether a link is a strict disk, and whether a set is in one piece.
struct Links {
  std::function<bool(LinkSet plus, LinkSet zero)> is_disk = certet::core::is_strict_disk;
  std::function<bool(LinkSet)> in_one_piece = certet::core::is_connected;
};

/// All 3^14 links, and all 2^14 sets.
Differences compare(const Links& production, std::size_t& disk_count) {
  Differences differences;
  disk_count = 0;
  for (LinkSet plus = 0; plus < all_sets; ++plus) {
    differences.expect(production.in_one_piece(plus) == certified::in_one_piece(plus),
                       [&] { return "set " + std::to_string(plus); });
    const std::vector<LinkSet> disks = certified::disks(plus);
    disk_count += disks.size();
    const LinkSet rest = (all_sets - 1) & ~plus;
    std::size_t next = 0;
    LinkSet zero = 0;
    do {
      const bool theirs = next < disks.size() && disks[next] == zero;
      next += theirs ? 1 : 0;
      differences.expect(production.is_disk(plus, zero) == theirs, [&] {
        return "+ " + std::to_string(plus) + ", 0 " + std::to_string(zero);
      });
      zero = (zero - rest) & rest;
    } while (zero != 0);
  }
  return differences;
}

TEST(Settle, EveryLinkIsJudgedAlike) {
  std::size_t disk_count = 0;
  const Differences differences = compare({}, disk_count);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 4782969 + 16384);
  EXPECT_EQ(disk_count, 1159754U);
}

TEST(Settle, CatchesOneBitOfTheTable) {
  std::size_t disk_count = 0;
  const Links spoiled{.is_disk =
                          [](LinkSet plus, LinkSet zero) {
                            return plus != 0x2001 && certet::core::is_strict_disk(plus, zero);
                          },
                      .in_one_piece =
                          [](LinkSet set) { return (set == 3) != certet::core::is_connected(set); }};
  EXPECT_FALSE(compare({.is_disk = spoiled.is_disk}, disk_count).empty());
  EXPECT_FALSE(compare({.in_one_piece = spoiled.in_one_piece}, disk_count).empty());
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

/// Few stay, and few moves are shortened: nearly the paper's warp.
TEST(Settle, ASphereComesOutNearlyAsByThePaper) {
  const auto sphere = domains::of_level(domains::sphere(1.37, -2.81, 0.59, 5.3));
  const Lattice lattice{{-6, -10, -6}, {9, 9, 8}};
  auto settled = certified::settle(angles, Gap::level, lattice, seen(sphere));
  auto stuffed = certified::stuff(angles, lattice, seen(sphere));
  std::ranges::sort(settled);
  std::ranges::sort(stuffed);
  std::vector<certified::PlacedTet> others;
  std::ranges::set_symmetric_difference(settled, stuffed, std::back_inserter(others));
  EXPECT_LT(others.size(), settled.size() / 10) << "a tetrahedron elsewhere is counted twice";
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

/// A wall across long edges near their quarters, rough: neighbours that move onto it from
/// either side would pass each other.
domains::Positional rough_wall(std::uint64_t seed) {
  return domains::of_level([=](double x, double y, double z) {
    const auto nearest = [](double c) { return static_cast<int>(std::lround(c)); };
    const std::uint64_t h = mixed(seed, nearest(y), nearest(z));
    const double rough = 0.13 * (static_cast<double>(h >> 11) * 0x1p-53 - 0.5);
    return std::max(x - 0.5 - rough, -4.5 - x);
  });
}

/// Some domains in which much stays or is shortened, and some samples are 0.
std::vector<domains::Positional> fields(int count) {
  std::vector<domains::Positional> all;
  for (int n = 0; n < count; ++n) {
    const std::uint64_t seed = mixed(test_seed(), n);
    all.push_back(rough_wall(seed));
    all.push_back(domains::random_cuts(seed, 60, {10, 20000, 32768, 50000}));
    all.push_back(domains::random_cuts(seed, 0, {0, 1, 18687, 18688, 26111, 26112, 65535}));
  }
  return all;
}

std::vector<certified::PlacedTet> sorted(std::vector<certified::PlacedTet> tets) {
  for (certified::PlacedTet& tet : tets) std::ranges::sort(tet);
  std::ranges::sort(tets);
  return tets;
}

Differences compare(const settling::Rule& rule) {
  constexpr Lattice lattice{{-6, -8, -4}, {6, 7, 6}};
  Differences differences;
  for (const domains::Positional& field : fields(12)) {
    settling::Model model(field, lattice, rule);
    const settling::Tets mesh = model.mesh();
    std::vector<certified::PlacedTet> ours;
    for (const auto& [a, b, c, d] : mesh.tets)
      ours.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    const auto theirs = certified::settle(angles, Gap::level, lattice, seen(field));
    differences.expect(sorted(ours) == sorted(theirs),
                       [&] { return "seed " + std::to_string(test_seed()); });
  }
  return differences;
}

TEST(Settle, TheModelAgrees) {
  const Differences differences = compare(settling::Rule{});
  EXPECT_TRUE(differences.empty()) << differences;
}

TEST(Settle, CatchesAClampThatIsForgotten) {
  EXPECT_FALSE(compare(settling::Rule{.clamp = false}).empty());
}

TEST(Settle, CatchesAMoveThatIsNotShortened) {
  EXPECT_FALSE(compare(settling::Rule{.shorten = false}).empty());
}

TEST(Settle, CatchesAClosedDiskForAStrictOne) {
  EXPECT_FALSE(compare(settling::Rule{.may_move = settling::is_closed_disk}).empty());
}

}  // namespace
