/// \file
/// The pieces of meshes, and where their surface is no manifold, against a plain count.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certet/count_pieces.hpp"
#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "plain_pieces.hpp"

namespace {

using namespace certet;
using domains::Positional;

const Frame frame{{3, -1, 2}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0.5};

plain::Mesh emitted(const Stuffing& stuffing) {
  Context context;
  const Mesh mesh = emit(stuffing, frame, context);
  plain::Mesh result;
  for (const Coord3& p : mesh.points) result.points.push_back(frame.world(p));
  for (const auto& t : std::get<0>(mesh.tets)) result.tets.push_back({t[0], t[1], t[2], t[3]});
  result.labels.assign(mesh.labels.begin(), mesh.labels.end());
  return result;
}

Pieces counted(const Stuffing& stuffing, int threads) {
  Context context;
  context.threads = threads;
  return stuffing.pieces(frame, context);
}

Pieces in_memory(const plain::Mesh& mesh) {
  Context context;
  return count_pieces(mesh.points, std::span<const plain::Four>(mesh.tets), mesh.labels, context);
}

/// Noise, sparse noise, and blocks of a few cells, in lattices with more layers than one
/// task joins, or more cells along a row than a word has.
Stuffing random_case(int n) {
  const std::uint64_t seed = mixed(test_seed(), n);
  const Positional noise = domains::random_cuts(seed, 20, {10, 9000, 20000, 32768, 50000});
  const auto in_blocks = [=](Coord3 p, int size, std::uint64_t parts) {
    const auto cell = [=](std::int32_t c) { return (c - 20000) >> size; };
    return mixed(seed, cell(p.x), cell(p.y), cell(p.z)) % parts == 0;
  };
  const Positional sparse([=](Coord3 p) {
    return in_blocks(p, 18, 4) ? noise.sign_at(p) : Sign::minus;
  });
  const Positional boxes([=](Coord3 p) {
    return in_blocks(p, 17, 3) ? Sign::plus : Sign::minus;
  });
  const std::array<const Positional*, 3> all{&noise, &sparse, &boxes};
  const std::array<Lattice, 3> lattices{{{{-6, -8, -40}, {6, 7, 38}},
                                         {{-70, -8, -6}, {72, 6, 7}},
                                         {{-6, -8, -4}, {9, 12, 9}}}};
  Context context;
  return {*all[static_cast<std::size_t>(n) % 3], lattices[static_cast<std::size_t>(n / 12) % 3],
          methods[static_cast<std::size_t>(n / 3) % 4].method, context};
}

TEST(Pieces, AreThoseOfAPlainCount) {
  std::uint64_t pieces = 0, touching = 0, edges = 0, vertices = 0;
  for (int n = 0; n < 72; ++n) {
    const Stuffing stuffing = random_case(n);
    const plain::Mesh mesh = emitted(stuffing);
    const Pieces expected = plain::count(mesh);
    ASSERT_EQ(counted(stuffing, 1), expected) << n;
    ASSERT_EQ(counted(stuffing, 3), expected) << n;
    ASSERT_EQ(in_memory(mesh), expected) << n;
    pieces += expected.whole.by_faces;
    touching += expected.whole.by_faces - expected.whole.by_vertices;
    edges += expected.surface.edges;
    vertices += expected.surface.vertices;
    if (stuffing.method() == Method::embedded) {
      EXPECT_EQ(expected.surface.vertices, 0U);
      EXPECT_EQ(expected.whole.by_faces, expected.whole.by_vertices);
    }
  }
  EXPECT_GT(pieces, 100U);
  EXPECT_GT(touching, 10U);
  EXPECT_GT(edges, 10U);
  EXPECT_GT(vertices, edges);
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

TEST(Pieces, PlantedFaultsArePlaced) {
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

TEST(Pieces, OfLabelsAreEachByItself) {
  plain::Mesh mesh = two_tets(3);
  mesh.labels = {4, 9};
  const Pieces pieces = in_memory(mesh);
  EXPECT_EQ(pieces.whole, (PieceCount{1, 1}));
  EXPECT_EQ(pieces.largest, 2U);
  EXPECT_EQ(pieces.regions, (std::vector<RegionPieces>{{4, {1, 1}}, {9, {1, 1}}}));
}

TEST(Pieces, BadTetrahedraAreLeftOut) {
  plain::Mesh mesh = two_tets(1);
  mesh.tets.push_back({0, 1, 2, 99});
  mesh.tets.push_back({0, 1, 1, 3});
  EXPECT_EQ(in_memory(mesh), in_memory(two_tets(1)));
}

}  // namespace
