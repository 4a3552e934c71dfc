/// \file
/// The lattice: all twelve cases, with neighbours and orders, at many anchors.

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "certified.hpp"
#include "differences.hpp"
#include "implementation.hpp"
#include "seed.hpp"

namespace {

using certet::StructuredTet;
using certet::StructuredTetCase;
using certet::StructuredTetId;

/// Even points around the origin, the corners of the range, and random points.
std::vector<Coord3> anchors() {
  std::vector<Coord3> points;
  for (std::int32_t z = -6; z <= 6; z += 2)
    for (std::int32_t y = -6; y <= 6; y += 2)
      for (std::int32_t x = -6; x <= 6; x += 2) points.push_back({x, y, z});
  constexpr std::int32_t limit = certet::anchor_limit;
  for (const std::int32_t z : {-limit, limit})
    for (const std::int32_t y : {-limit, limit})
      for (const std::int32_t x : {-limit, limit}) points.push_back({x, y, z});
  std::mt19937_64 random(test_seed());
  for (int i = 0; i < 2000; ++i) {
    const std::int32_t x = between(random, -limit, limit);
    const std::int32_t y = between(random, -limit, limit);
    const std::int32_t z = between(random, -limit, limit);
    points.push_back({x, y, z});
  }
  return points;
}

bool same(const StructuredTet& a, const StructuredTet& b) {
  bool agree = a.vertices == b.vertices;
  for (std::size_t i = 0; i < 4; ++i)
    agree = agree && a.neighbors[i].id == b.neighbors[i].id &&
            a.neighbors[i].order == b.neighbors[i].order;
  return agree;
}

Differences compare(const Implementation& production) {
  Differences differences;
  for (const Coord3 anchor : anchors())
    for (const StructuredTetCase orientation : certified::all_cases()) {
      const StructuredTetId id{anchor, orientation};
      differences.expect(
          same(production.structured_tet(id), certified::structured_tet(id)), [&] {
            std::ostringstream out;
            out << "case " << certet::case_names[static_cast<std::size_t>(orientation)]
                << " at " << anchor.x << ' ' << anchor.y << ' ' << anchor.z;
            return out.str();
          });
    }
  for (const StructuredTetCase orientation : certified::all_cases())
    differences.expect(
        production.right_handed(orientation) == certified::right_handed(orientation), [&] {
          return "the handedness of " +
                 std::string(certet::case_names[static_cast<std::size_t>(orientation)]);
        });
  return differences;
}

TEST(StructuredTet, TwelveCases) {
  EXPECT_EQ(certified::all_cases().size(), std::size_t{certet::case_count});
}

TEST(StructuredTet, IsTheSame) {
  const Differences differences = compare({});
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), (7 * 7 * 7 + 8 + 2000) * 12 + 12);
}

/// The same implementation, but for one case changed by `spoil`.
template <class Spoil>
Implementation with(StructuredTetCase orientation, const Spoil& spoil) {
  Implementation broken;
  broken.structured_tet = [=](const StructuredTetId& id) {
    StructuredTet tet = certet::structured_tet(id);
    if (id.orientation == orientation) spoil(tet);
    return tet;
  };
  return broken;
}

TEST(StructuredTet, CatchesANeighborOneCellOff) {
  EXPECT_FALSE(compare(with(StructuredTetCase::J3, [](StructuredTet& t) {
                 t.neighbors[1].id.anchor.z -= 2;
               })).empty());
}

TEST(StructuredTet, CatchesAnotherNeighbor) {
  EXPECT_FALSE(compare(with(StructuredTetCase::I4, [](StructuredTet& t) {
                 std::swap(t.neighbors[2].id.orientation, t.neighbors[3].id.orientation);
               })).empty());
}

TEST(StructuredTet, CatchesAnOrder) {
  EXPECT_FALSE(compare(with(StructuredTetCase::K2, [](StructuredTet& t) {
                 t.neighbors[0].order = certet::order_2143;
               })).empty());
}

TEST(StructuredTet, CatchesSwappedVertices) {
  EXPECT_FALSE(compare(with(StructuredTetCase::K4, [](StructuredTet& t) {
                 std::swap(t.vertices[2], t.vertices[3]);
               })).empty());
}

TEST(StructuredTet, CatchesAHandedness) {
  Implementation broken;
  broken.right_handed = [](StructuredTetCase c) {
    return certet::right_handed(c) != (c == StructuredTetCase::I3);
  };
  EXPECT_FALSE(compare(broken).empty());
}

}  // namespace
