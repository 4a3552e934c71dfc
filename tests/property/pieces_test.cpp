/// \file
/// The pieces of a mesh, counted by the signs of its lattice, and what is left when some
/// are dropped, against a plain count over all tetrahedra.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "piece_cases.hpp"

namespace {

using namespace piece_cases;

Pieces counted(const Stuffing& stuffing, int threads) {
  Context context;
  context.threads = threads;
  return stuffing.pieces(frame, context);
}

TEST(Pieces, AreThoseOfAPlainCount) {
  std::uint64_t pieces = 0, touching = 0, edges = 0, vertices = 0;
  for (int n = 0; n < 72; ++n) {
    const auto [domain, stuffing] = random_case(n);
    const Pieces expected = plain::count(emitted(stuffing));
    ASSERT_EQ(counted(stuffing, 1), expected) << n;
    ASSERT_EQ(counted(stuffing, 3), expected) << n;
    pieces += expected.whole.by_faces;
    touching += expected.whole.by_faces - expected.whole.by_vertices;
    edges += expected.surface.edges;
    vertices += expected.surface.vertices;
    if (facts(stuffing.method()).settles) {
      EXPECT_EQ(expected.surface.vertices, 0U);
      EXPECT_EQ(expected.whole.by_faces, expected.whole.by_vertices);
    }
  }
  EXPECT_GT(pieces, 100U);
  EXPECT_GT(touching, 10U);
  EXPECT_GT(edges, 10U);
  EXPECT_GT(vertices, edges);
}

using PlacedTet = std::array<Point3, 4>;

/// Tetrahedra by the places of their corners, in their order.
std::vector<PlacedTet> placed(const plain::Mesh& mesh, std::vector<std::size_t> some) {
  std::ranges::sort(some);
  std::vector<PlacedTet> all;
  for (const std::size_t n : some) {
    const auto [a, b, c, d] = mesh.tets[n];
    all.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
  }
  return all;
}

std::vector<std::size_t> all_of(const plain::Mesh& mesh) {
  std::vector<std::size_t> all(mesh.tets.size());
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = n;
  return all;
}

/// A mesh with some tetrahedra alone of another, as they were there; no point is left over.
void expect_part(const Stuffing& stuffing, const plain::Mesh& whole,
                 const std::vector<std::size_t>& tets) {
  const plain::Mesh part = emitted(stuffing);
  ASSERT_EQ(placed(part, all_of(part)), placed(whole, tets));
  std::set<std::uint64_t> used;
  for (const plain::Four& tet : part.tets) used.insert(tet.begin(), tet.end());
  EXPECT_EQ(used.size(), part.points.size());
  EXPECT_EQ(std::set(part.points.begin(), part.points.end()).size(), part.points.size());
  EXPECT_EQ(counted(stuffing, 2), plain::count(part));
}

/// What a rule keeps, and what it drops.
void expect_kept(Stuffing& stuffing, const plain::Mesh& before, const KeepRule& rule,
                 const std::vector<std::vector<std::size_t>>& pieces,
                 const std::vector<bool>& stays, int threads) {
  std::vector<std::size_t> kept, dropped;
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    std::vector<std::size_t>& part = stays[n] ? kept : dropped;
    part.insert(part.end(), pieces[n].begin(), pieces[n].end());
  }
  Context context;
  context.threads = threads;
  const Stuffing rest = stuffing.keep(rule, context);
  expect_part(stuffing, before, kept);
  expect_part(rest, before, dropped);
}

TEST(Keep, LeavesTheLargestAsTheyWere) {
  std::uint64_t kept = 0, dropped = 0;
  for (int n = 0; n < 36; ++n) {
    auto [domain, stuffing] = random_case(n);
    const plain::Mesh mesh = emitted(stuffing);
    auto pieces = plain::pieces(mesh, 3);
    std::ranges::stable_sort(pieces, std::ranges::greater(), &std::vector<std::size_t>::size);
    auto count = 1 + static_cast<std::size_t>(n) % 4;
    // Which of equals begins first is told by lattice points, not by tetrahedra.
    while (count < pieces.size() && pieces[count - 1].size() == pieces[count].size()) ++count;
    std::vector<bool> stays(pieces.size(), false);
    for (std::size_t m = 0; m < std::min(count, pieces.size()); ++m) stays[m] = true;
    for (std::size_t m = 0; m < pieces.size(); ++m)
      (stays[m] ? kept : dropped) += pieces[m].size();
    expect_kept(stuffing, mesh, KeepLargest{count}, pieces, stays, 1 + n % 3);
  }
  EXPECT_GT(kept, 1000U);
  EXPECT_GT(dropped, 1000U);
}

/// Two bars from end to end, one along x and one along y, and one that is too short.
TEST(Keep, LeavesWhatGoesThrough) {
  const Positional bars([](Coord3 p) {
    const auto unit = [](std::int32_t c) { return static_cast<double>(c) / steps; };
    const double x = unit(p.x), y = unit(p.y), z = unit(p.z);
    const auto bar = [](double a, double b, double c, double d) {
      return std::hypot(a - c, b - d) < 1.3;
    };
    const bool along_x = std::abs(x) < 9.1 && bar(y, z, -5, -5);
    const bool along_y = std::abs(y) < 9.1 && bar(x, z, 5, 5);
    const bool short_x = x > -2 && x < 9 && bar(y, z, 5, 0);
    return along_x || along_y || short_x ? Sign::plus : Sign::minus;
  });
  const Lattice lattice{{-12, -12, -12}, {12, 12, 12}};
  for (const Method method : {Method::embedded, Method::midpoint})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Context context;
      Stuffing stuffing(bars, lattice, method, context);
      const plain::Mesh mesh = emitted(stuffing);
      const auto pieces = plain::pieces(mesh, 3);
      ASSERT_EQ(pieces.size(), 3U);
      std::vector<bool> stays;
      for (const auto& piece : pieces) {
        double low = 99, high = -99;
        for (const std::size_t t : piece)
          for (const std::uint64_t p : mesh.tets[t]) {
            low = std::min(low, mesh.points[p][axis] - frame.origin[axis]);
            high = std::max(high, mesh.points[p][axis] - frame.origin[axis]);
          }
        // A lattice unit is a quarter of a world unit here.
        stays.push_back(low < -1.7 && high > 1.7 && high - low > 4);
      }
      EXPECT_EQ(std::ranges::count(stays, true), axis == 2 ? 0 : 1);
      expect_kept(stuffing, mesh, KeepPercolating{axis}, pieces, stays, 2);
    }
}

}  // namespace
