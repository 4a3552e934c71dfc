/// \file
/// Odd points that join groups of even ones: every neighbourhood, and a lattice full of them.

#include <gtest/gtest.h>

#include <functional>

#include "certified.hpp"
#include "differences.hpp"
#include "domains.hpp"
#include "engine/part_cubes.hpp"
#include "samples.hpp"

namespace {

using namespace certet;
using core::CubeCorners;

/// The production side, as a value.
using PartedCubes = std::function<std::uint64_t(const CubeCorners&)>;

/// Each point of the lattice is in a voxel of its own.
constexpr certified::VoxelGrid one_each{1, {1, 1, 1}, {0, 0, 0}};

/// Each of the 2^8 sets of corners, 64 at a time, with the centre inside and outside.
Differences compare_cubes(const PartedCubes& parted_cubes) {
  Differences differences;
  for (std::uint32_t first = 0; first < 256; first += 64) {
    CubeCorners corners{};
    for (std::uint32_t set = first; set < first + 64; ++set)
      for (std::uint32_t n = 0; n < 8; ++n)
        corners[n] |= std::uint64_t{set >> n & 1} << (set - first);
    const std::uint64_t parted = parted_cubes(corners);
    for (std::uint32_t set = first; set < first + 64; ++set)
      for (const bool centre : {false, true}) {
        constexpr Coord3 odd{7, -3, 5};
        const auto holds = [&](Coord3 voxel) {
          const Coord3 d = voxel - odd;
          if (d == Coord3{0, 0, 0}) return centre;
          const auto upper = [](std::int32_t c) { return c > 0 ? 1U : 0U; };
          return (set >> (upper(d.x) | upper(d.y) << 1 | upper(d.z) << 2) & 1) != 0;
        };
        const bool plus = centre && (parted >> (set - first) & 1) == 0;
        differences.expect(certified::voxel_sign(one_each, holds, odd) ==
                               (plus ? Sign::plus : Sign::minus),
                           [&] { return "corners " + std::to_string(set); });
      }
  }
  return differences;
}

/// How many groups the corners of one cube are in.
int groups(std::uint32_t set) {
  int count = 0;
  while (set != 0) {
    std::uint32_t group = set & -set;
    for (std::uint32_t before = 0; before != group;) {
      before = group;
      for (std::uint32_t n = 0; n < 8; ++n)
        for (const std::uint32_t beside : {n ^ 1, n ^ 2, n ^ 4})
          if ((group >> n & 1) != 0) group |= set & 1U << beside;
    }
    set &= ~group;
    ++count;
  }
  return count;
}

/// Cubes with at least so many groups.
PartedCubes with_groups(int least) {
  return [=](const CubeCorners& corners) {
    std::uint64_t parted = 0;
    for (int b = 0; b < 64; ++b) {
      std::uint32_t set = 0;
      for (std::size_t n = 0; n < 8; ++n)
        set |= static_cast<std::uint32_t>(corners[n] >> b & 1) << n;
      if (groups(set) >= least) parted |= std::uint64_t{1} << b;
    }
    return parted;
  };
}

TEST(Cubes, EachIsPartedAlike) {
  const Differences differences = compare_cubes(core::parted_cubes);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 512);
  EXPECT_TRUE(compare_cubes(with_groups(2)).empty());
}

TEST(Cubes, CatchesARuleThatIsForgotten) {
  EXPECT_FALSE(compare_cubes([](const CubeCorners&) { return std::uint64_t{0}; }).empty());
}

TEST(Cubes, CatchesOneGroupMoreOrLess) {
  EXPECT_FALSE(compare_cubes(with_groups(3)).empty());
  EXPECT_FALSE(compare_cubes(with_groups(1)).empty());
}

/// Every sample of a lattice, some rows of which are longer than a word.
Differences compare_samples(const MethodFacts& method) {
  Differences differences;
  constexpr Lattice lattice{{-4, 2, -6}, {70, 5, 6}};
  const auto noise = domains::noise(test_seed(), 0);
  const domains::Parted domain([&](Coord3 p) { return noise.sign_at(p); });
  const auto holds = [&](Coord3 v) {
    const Coord3 d = v - lattice.origin;
    const auto within = [](std::int32_t c, std::int32_t cells) { return c >= 2 && c < 2 * cells - 2; };
    return within(d.x, lattice.cells[0]) && within(d.y, lattice.cells[1]) &&
           within(d.z, lattice.cells[2]) && noise.sign_at(steps * v) == Sign::plus;
  };
  expect_samples_of(one_each, holds, domain, lattice, method, differences);
  return differences;
}

TEST(Cubes, TheSamplesOfALatticeAreAlike) {
  const Differences differences = compare_samples(facts(Method::embedded));
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 4200);
}

/// The paper's method samples odd points as they are.
TEST(Cubes, CatchesSamplesAsTheyAre) {
  EXPECT_FALSE(compare_samples(facts(Method::angles)).empty());
}

}  // namespace
