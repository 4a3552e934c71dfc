/// \file
/// The link of a vertex: its table, and all of its 3^14 signs.

#include <gtest/gtest.h>

#include "engine/link.hpp"
#include "settling_model.hpp"

namespace {

using namespace certet;

using Table = std::array<std::uint64_t, core::connected_sets.size()>;

/// By a flood from one member to the others.
bool connected(core::LinkSet set) {
  std::vector<std::size_t> reached;
  core::LinkSet rest = set;
  const auto reach = [&](std::size_t d) {
    reached.push_back(d);
    rest &= ~(core::LinkSet{1} << d);
  };
  if (set != 0) reach(static_cast<std::size_t>(std::countr_zero(set)));
  for (std::size_t n = 0; n < reached.size(); ++n)
    for (std::size_t e = 0; e < direction_count; ++e) {
      const Coord3 difference = direction_offset[e] - direction_offset[reached[n]];
      if ((rest >> e & 1) != 0 && std::ranges::count(direction_offset, difference) != 0) reach(e);
    }
  return set != 0 && rest == 0;
}

int wrong_entries(const Table& table) {
  static const std::vector<bool> right = [] {
    std::vector<bool> all;
    for (core::LinkSet set = 0; set <= core::whole_link; ++set) all.push_back(connected(set));
    return all;
  }();
  int wrong = 0;
  for (core::LinkSet set = 0; set <= core::whole_link; ++set)
    wrong += ((table[set >> 6] >> (set & 63) & 1) != 0) != right[set];
  return wrong;
}

TEST(Link, TheTableTellsWhichSetsAreInOnePiece) { EXPECT_EQ(wrong_entries(core::connected_sets), 0); }

TEST(Link, EachBitOfTheTableMatters) {
  Table spoiled = core::connected_sets;
  for (core::LinkSet set = 0; set <= core::whole_link; set += 37) {
    spoiled[set >> 6] ^= std::uint64_t{1} << (set & 63);
    ASSERT_EQ(wrong_entries(spoiled), 1);
    spoiled[set >> 6] ^= std::uint64_t{1} << (set & 63);
  }
}

TEST(Link, IsASphere) {
  int edges = 0;
  int triangles = 0;
  for (std::size_t d = 0; d < direction_count; ++d) {
    EXPECT_EQ(std::popcount(core::link_ring[d]), is_long(static_cast<int>(d)) ? 4 : 6);
    EXPECT_TRUE(core::is_connected(core::link_ring[d]));
    for (std::size_t e = 0; e < direction_count; ++e) {
      if ((core::link_ring[d] >> e & 1) == 0) continue;
      ++edges;
      const core::LinkSet sides = core::LinkSet{core::link_ring[d]} & core::link_ring[e];
      EXPECT_EQ(std::popcount(sides), 2);
      triangles += std::popcount(sides);
    }
  }
  EXPECT_EQ(edges, 2 * 36);
  EXPECT_EQ(triangles, 6 * 24);
}

/// Signs as a number in base 3: one of 3^14 links.
struct NumberedLink {
  settling::LinkSigns signs{};
  core::LinkSet plus = 0, zero = 0;

  explicit NumberedLink(int number) {
    for (std::size_t d = 0; d < direction_count; ++d, number /= 3) {
      signs[d] = static_cast<Sign>(number % 3);
      plus |= core::LinkSet{signs[d] == Sign::plus} << d;
      zero |= core::LinkSet{signs[d] == Sign::on_surface} << d;
    }
  }
};
constexpr int link_count = 4782969;

TEST(Link, StrictDisksAreCounted) {
  int disks = 0;
  for (int n = 0; n < link_count; ++n) {
    const NumberedLink link(n);
    disks += core::is_strict_disk(link.plus, link.zero);
  }
  EXPECT_EQ(disks, 1159754);
}

/// A part of all links, chosen by chance; those where the table decides nothing are few.
TEST(Link, StrictDisksAreThoseOfTheDefinition) {
  const auto offset = static_cast<int>(test_seed() % 97);
  int closed_only = 0;
  for (int n = offset; n < link_count; n += 97) {
    const NumberedLink link(n);
    const bool strict = settling::is_strict_disk(link.signs);
    ASSERT_EQ(core::is_strict_disk(link.plus, link.zero), strict) << n;
    closed_only += settling::is_closed_disk(link.signs) && !strict;
  }
  EXPECT_GT(closed_only, 100);
}

}  // namespace
