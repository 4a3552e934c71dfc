// Which middle nodes a mesh has, and their numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "certet/bounded_function.hpp"
#include "certet/error.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/stuffing.hpp"

namespace certet {
namespace {

using Tet64 = Tet<std::uint64_t>;

TEST(MiddleNodes, OneTetrahedronHasSix) {
  const std::vector<Tet64> tets{{3, 1, 0, 2}};
  const MiddleNodes nodes = middle_nodes(4, tets);
  EXPECT_EQ(nodes.corners(), 4u);
  EXPECT_EQ(nodes.count(), 6u);
  // 0-1, 0-2, 0-3, 1-2, 1-3, 2-3; the edges of the tetrahedron are 3-1, 1-0, 3-0, 3-2, 1-2, 0-2.
  EXPECT_EQ(nodes.of(tets[0]), (std::array<std::uint64_t, 6>{4, 0, 2, 5, 3, 1}));
  EXPECT_EQ(nodes.between(2, 0), nodes.between(0, 2));
  EXPECT_EQ(nodes.between(1, 1), nodes.count());
  EXPECT_EQ(nodes.between(1, 7), nodes.count());
}

TEST(MiddleNodes, ACubeOfSixTetrahedraHas19Edges) {
  // Around the diagonal 0-7: 12 edges, 6 diagonals of faces, and itself.
  const std::vector<Tet64> tets{{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  const MiddleNodes nodes = middle_nodes(8, tets);
  EXPECT_EQ(nodes.count(), 19u);
  std::uint64_t expected = 0;
  std::array<std::uint64_t, 2> before{0, 0};
  nodes.for_each(0, 8, [&](std::uint64_t node, std::uint64_t a, std::uint64_t b) {
    EXPECT_EQ(node, expected++);
    EXPECT_LT(before, (std::array<std::uint64_t, 2>{a, b}));
    EXPECT_EQ(nodes.between(a, b), node);
    before = {a, b};
  });
  EXPECT_EQ(expected, 19u);
}

TEST(MiddleNodes, APointThatIsNotThereIsRefused) {
  EXPECT_THROW(middle_nodes(4, std::vector<Tet64>{{0, 1, 2, 4}}), Error);
}

/// Layer by layer they are those of the whole, for any number of threads.
TEST(MiddleNodes, LayersGiveWhatTheWholeGives) {
  const BoundedFunction domain([](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
                               {{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}, 0.2);
  Context context;
  const Stuffing stuffing(domain, domain.lattice(), Method::embedded, context);
  const Mesh whole = mesh(domain, stuffing, context);
  const MiddleNodes expected = middle_nodes(whole);
  std::set<std::array<std::uint64_t, 2>> edges;
  std::visit(
      [&](const auto& tets) {
        for (const auto& tet : tets)
          for (const auto& [i, j] : tet_edges)
            edges.insert({std::min<std::uint64_t>(tet[i], tet[j]),
                          std::max<std::uint64_t>(tet[i], tet[j])});
      },
      whole.tets);
  EXPECT_EQ(expected.count(), edges.size());
  for (const int threads : {1, 3}) {
    Context own;
    own.threads = threads;
    const MiddleNodes found = middle_nodes(stuffing, own);
    ASSERT_EQ(found.count(), expected.count());
    auto edge = edges.begin();
    found.for_each(0, found.corners(), [&](std::uint64_t, std::uint64_t a, std::uint64_t b) {
      EXPECT_EQ(*edge++, (std::array<std::uint64_t, 2>{a, b}));
    });
  }
}

TEST(MiddleNodes, TheyLieBetweenTheirEnds) {
  Frame frame;
  frame.size = 3;
  frame.origin = {1, 2, 3};
  const Coord3 a{2'000'000'001, -7, 0}, b{2'000'000'000, 8, 6};
  const Point3 p = frame.world(a), q = frame.world(b);
  const Point3 middle = middle_in_world(frame, a, b, {0, 0, 0});
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(middle[axis], (p[axis] + q[axis]) / 2, 1e-8);
  // Bent by two half steps it is where a step takes it.
  const Point3 there = frame.world({5, 6, 7});
  EXPECT_EQ(middle_in_world(frame, {4, 6, 7}, {4, 6, 7}, {2, 0, 0}), there);
}

}  // namespace
}  // namespace certet
