/// \file
/// The pieces of meshes of several materials, counted by signs and materials, and what is
/// left when some are dropped, against a plain count over all tetrahedra.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "materials.hpp"
#include "piece_cases.hpp"

namespace {

using namespace piece_cases;

struct RegionCase {
  std::unique_ptr<materials::Positional> domain;
  Stuffing stuffing;
};

/// Cubes of random materials, dense and sparse, and noise; both methods that cut materials
/// apart; rows longer than a word, and many layers.
RegionCase region_case(int n) {
  const std::uint64_t seed = mixed(test_seed(), n);
  const int side = std::array{1, 2, 3}[static_cast<std::size_t>(n) % 3];
  const auto cubes = materials::cubes(seed, side, {3, 5, 6}, n % 2 == 0 ? 200 : 90);
  const auto moved = static_cast<std::int32_t>(seed % 8) * (steps / 8) + 77;
  auto domain = std::make_unique<materials::Positional>(
      std::vector<std::int32_t>{3, 5, 6},
      [=](Coord3 p) { return cubes.material_at(p + Coord3{moved, moved, moved}); });
  const std::array<Lattice, 3> lattices{{{{-6, -8, -40}, {6, 7, 38}},
                                         {{-70, -8, -6}, {72, 6, 7}},
                                         {{-6, -8, -4}, {9, 12, 9}}}};
  Context context;
  Stuffing stuffing(*domain, lattices[static_cast<std::size_t>(n / 4) % 3],
                    n / 2 % 2 == 0 ? Method::embedded : Method::midpoint, context);
  return {std::move(domain), std::move(stuffing)};
}

Pieces counted(const Stuffing& stuffing, int threads) {
  Context context;
  context.threads = threads;
  return stuffing.pieces(frame, context);
}

TEST(RegionsBySigns, AreThoseOfAPlainCount) {
  std::uint64_t pieces = 0, touching = 0, faults = 0;
  for (int n = 0; n < 48; ++n) {
    const auto [domain, stuffing] = region_case(n);
    ASSERT_TRUE(stuffing.has_interfaces());
    const Pieces expected = plain::count(emitted(stuffing));
    ASSERT_EQ(counted(stuffing, 1).whole, expected.whole) << n;
    ASSERT_EQ(counted(stuffing, 1).regions, expected.regions) << n;
    ASSERT_EQ(counted(stuffing, 1), expected) << n;
    ASSERT_EQ(counted(stuffing, 3), expected) << n;
    pieces += expected.whole.by_faces;
    touching += expected.whole.by_faces - expected.whole.by_vertices;
    faults += expected.surface.vertices;
  }
  EXPECT_GT(pieces, 100U);
  EXPECT_GT(touching, 10U);
  EXPECT_GT(faults, 10U);
}

/// Blocks of voxels a little longer than an edge, with single ones that differ: steps along
/// which many vertices move in different directions, so that tetrahedra of four moved ones
/// are kept.
RegionCase jagged_case(int n) {
  const std::uint64_t seed = mixed(test_seed(), 1000 + n);
  const std::int32_t width = steps * (20 + n % 5) / 10;
  auto domain = std::make_unique<materials::Positional>(
      std::vector<std::int32_t>{3, 5, 6}, [=](Coord3 p) -> Material {
        const auto voxel = [=](std::int32_t c) { return (c + 100 * width) / width; };
        const int x = voxel(p.x), y = voxel(p.y), z = voxel(p.z);
        const bool differs = mixed(seed, x, y, z) % 8 == 0;
        return static_cast<Material>((differs ? mixed(seed, x, y, z) >> 8
                                              : mixed(seed, x >> 2, y >> 2, z >> 2)) % 4);
      });
  Context context;
  Stuffing stuffing(*domain, {{-10, -8, -12}, {11, 10, 12}}, Method::embedded, context);
  return {std::move(domain), std::move(stuffing)};
}

TEST(RegionsBySigns, OfJaggedOnesAreThoseOfAPlainCount) {
  for (int n = 0; n < 16; ++n) {
    auto [domain, stuffing] = jagged_case(n);
    ASSERT_EQ(counted(stuffing, 1), plain::count(emitted(stuffing))) << n;
    Context context;
    const Stuffing rest = stuffing.keep(KeepPercolating{1}, context);
    ASSERT_EQ(counted(stuffing, 2), plain::count(emitted(stuffing))) << n;
    ASSERT_EQ(counted(rest, 3), plain::count(emitted(rest))) << n;
  }
}

using LabelledTet = std::tuple<std::array<Point3, 4>, std::int32_t>;

std::vector<LabelledTet> labelled(const Stuffing& stuffing) {
  const plain::Mesh mesh = emitted(stuffing);
  std::vector<LabelledTet> all;
  for (std::size_t n = 0; n < mesh.tets.size(); ++n) {
    const auto [a, b, c, d] = mesh.tets[n];
    all.push_back(
        {{mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]}, mesh.labels[n]});
  }
  std::ranges::sort(all);
  return all;
}

/// Points that no tetrahedron has.
std::size_t idle_points(const Stuffing& stuffing) {
  const plain::Mesh mesh = emitted(stuffing);
  std::set<std::uint64_t> used;
  for (const auto& tet : mesh.tets) used.insert(tet.begin(), tet.end());
  return mesh.points.size() - used.size();
}

/// Whatever stays, nothing is lost, and nothing is made.
TEST(RegionsBySigns, WhatStaysAndTheRestAreTheWhole) {
  for (int n = 0; n < 24; ++n)
    for (const KeepRule rule : {KeepRule(KeepLargest{2}), KeepRule(KeepPercolating{2})}) {
      auto [domain, stuffing] = region_case(n);
      const std::vector<LabelledTet> before = labelled(stuffing);
      Context context;
      const Stuffing rest = stuffing.keep(rule, context);
      std::vector<LabelledTet> after = labelled(stuffing);
      const std::vector<LabelledTet> others = labelled(rest);
      after.insert(after.end(), others.begin(), others.end());
      std::ranges::sort(after);
      ASSERT_TRUE(after == before) << n;
      ASSERT_EQ(idle_points(stuffing) + idle_points(rest), 0U) << n;
    }
}

TEST(RegionsBySigns, TheLargestStaysAndTheRestIsDropped) {
  std::uint64_t dropped_pieces = 0;
  for (int n = 0; n < 24; ++n) {
    auto [domain, stuffing] = region_case(n);
    const std::vector<LabelledTet> before = labelled(stuffing);
    const Pieces pieces = counted(stuffing, 1);
    Context context;
    const Stuffing rest = stuffing.keep(KeepLargest{1}, context);
    const Pieces kept = plain::count(emitted(stuffing));
    ASSERT_EQ(kept.whole.by_faces, std::min<std::uint64_t>(1, pieces.whole.by_faces)) << n;
    ASSERT_EQ(stuffing.tet_count(), pieces.largest) << n;
    ASSERT_EQ(counted(stuffing, 1), kept) << n;
    std::vector<LabelledTet> after = labelled(stuffing);
    const std::vector<LabelledTet> others = labelled(rest);
    after.insert(after.end(), others.begin(), others.end());
    std::ranges::sort(after);
    std::vector<LabelledTet> lost, gained;
    std::ranges::set_difference(before, after, std::back_inserter(lost));
    std::ranges::set_difference(after, before, std::back_inserter(gained));
    ASSERT_EQ(lost, gained) << n << ", of " << before.size();
    dropped_pieces += pieces.whole.by_faces - kept.whole.by_faces;
  }
  EXPECT_GT(dropped_pieces, 50U);
}

}  // namespace
