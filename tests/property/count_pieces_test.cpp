/// \file
/// The pieces of meshes in memory, against a plain count.

#include <gtest/gtest.h>

#include "certet/count_pieces.hpp"
#include "piece_cases.hpp"

namespace {

using namespace piece_cases;

Pieces in_memory(const plain::Mesh& mesh) {
  Context context;
  return count_pieces(mesh.points, std::span<const plain::Four>(mesh.tets), mesh.labels, context);
}

TEST(FilePieces, AreThoseOfAPlainCount) {
  for (int n = 12; n < 36; ++n) {
    const plain::Mesh mesh = emitted(random_case(n).stuffing);
    ASSERT_EQ(in_memory(mesh), plain::count(mesh)) << n;
  }
}

/// Labels by the place of a tetrahedron, and others without any order.
TEST(FilePieces, OfLabelsAreThoseOfAPlainCount) {
  std::uint64_t split = 0;
  for (int n = 24; n < 36; ++n) {
    plain::Mesh mesh = emitted(random_case(n).stuffing);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const Point3& at = mesh.points[mesh.tets[t][0]];
      const auto block = [](double c) { return static_cast<std::int64_t>(c + 1000); };
      mesh.labels.push_back(static_cast<std::int32_t>(
          (n % 2 == 0 ? mixed(test_seed(), block(at[0]), block(at[1]), block(at[2]))
                      : mixed(test_seed(), t)) % 3));
    }
    const Pieces expected = plain::count(mesh);
    ASSERT_EQ(in_memory(mesh), expected) << n;
    for (const RegionPieces& region : expected.regions)
      split += region.pieces.by_faces - region.pieces.by_vertices;
  }
  EXPECT_GT(split, 10U);
}

/// Tetrahedra that share so many points, the first with the numbers 0 to 3.
plain::Mesh two_tets(std::size_t shared) {
  plain::Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  plain::Four other{};
  for (std::size_t v = 0; v < 4; ++v) {
    other[v] = v < shared ? v : mesh.points.size();
    if (v >= shared)
      mesh.points.push_back({v == 1 ? -1.0 : 0.0, v == 2 ? -1.0 : 0.0, v == 3 ? -1.0 : 0.0});
  }
  std::swap(other[0], other[1]);
  mesh.tets.push_back(other);
  return mesh;
}

TEST(FilePieces, PlantedFaultsArePlaced) {
  const auto found = [](std::size_t shared) { return in_memory(two_tets(shared)); };
  EXPECT_EQ(found(0).whole, (PieceCount{2, 2}));
  EXPECT_EQ(found(0).surface, SurfaceFaults{});
  EXPECT_EQ(found(1).whole, (PieceCount{2, 1}));
  EXPECT_EQ(found(1).surface, (SurfaceFaults{0, 1, {}, {{0, 0, 0}}}));
  EXPECT_EQ(found(2).whole, (PieceCount{2, 1}));
  EXPECT_EQ(found(2).surface, (SurfaceFaults{1, 2, {{0.5, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}}));
  EXPECT_EQ(found(3).whole, (PieceCount{1, 1}));
  EXPECT_EQ(found(3).surface, SurfaceFaults{});
}

TEST(FilePieces, OfLabelsAreEachByItself) {
  plain::Mesh mesh = two_tets(3);
  mesh.labels = {4, 9};
  const Pieces pieces = in_memory(mesh);
  EXPECT_EQ(pieces.whole, (PieceCount{1, 1}));
  EXPECT_EQ(pieces.largest, 2U);
  EXPECT_EQ(pieces.regions, (std::vector<RegionPieces>{{4, {1, 1}}, {9, {1, 1}}}));
}

TEST(FilePieces, BadTetrahedraAreLeftOut) {
  plain::Mesh mesh = two_tets(1);
  mesh.tets.push_back({0, 1, 2, 99});
  mesh.tets.push_back({0, 1, 1, 3});
  EXPECT_EQ(in_memory(mesh), in_memory(two_tets(1)));
}

}  // namespace
