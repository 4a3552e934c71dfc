/// \file
/// Lattices around boxes of the world.

#include "certet/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certet/error.hpp"

namespace certet {
namespace {

constexpr Bounds box{{-1, 2, 10}, {3, 5, 26.5}};

ErrorCode code_of(const Bounds& bounds, double size, std::int32_t margin) {
  try {
    static_cast<void>(lattice_around(bounds, size, margin));
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Bounds, TheLongestSide) {
  EXPECT_EQ(longest_side(box), 16.5);
  EXPECT_EQ(longest_side({{0, -9, 0}, {8, 1, 9}}), 10);
  EXPECT_EQ(longest_side({{-7, 0, 1}, {4, 5, 9}}), 11);
}

TEST(Bounds, TheLatticeHasItsPointZeroInTheMiddle) {
  const PlacedLattice around = lattice_around(box, 0.5, 1);
  EXPECT_EQ(around.frame.size, 0.5);
  EXPECT_EQ(around.frame.origin, (Point3{1, 3.5, 18.25}));
  EXPECT_EQ(around.lattice.cells, (std::array<std::int32_t, 3>{2 * (4 + 1), 2 * (3 + 1), 2 * (17 + 1)}));
  EXPECT_EQ(around.lattice.origin, (Coord3{-10, -8, -36}));
  EXPECT_EQ(lattice_around(box, 0.5, 3).lattice.cells,
            (std::array<std::int32_t, 3>{2 * (4 + 3), 2 * (3 + 3), 2 * (17 + 3)}));
}

/// At least `margin` cells lie between the bounds and the end, on every side.
TEST(Bounds, TheMarginIsKept) {
  for (const double size : {0.1, 0.37, 1.0, 4.9})
    for (const std::int32_t margin : {1, 2, 5}) {
      const PlacedLattice around = lattice_around(box, size, margin);
      for (std::size_t a = 0; a < 3; ++a) {
        const double half = 0.5 * around.lattice.cells[a] * around.frame.size;
        EXPECT_LE(around.frame.origin[a] - half, box.low[a] - margin * size + 1e-9);
        EXPECT_GE(around.frame.origin[a] + half, box.high[a] + margin * size - 1e-9);
      }
    }
}

TEST(Bounds, WithoutASizeTheLongestSideHasSixtyFourCells) {
  const PlacedLattice around = lattice_around(box, 0, 1);
  EXPECT_EQ(around.frame.size, 16.5 / 64);
  EXPECT_EQ(around.lattice.cells[2], 64 + 2);
}

TEST(Bounds, WhatIsNoBoxIsRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a)
    for (const double high : {box.low[a], box.low[a] - 1, infinity, std::nan("")}) {
      Bounds bounds = box;
      bounds.high[a] = high;
      EXPECT_EQ(code_of(bounds, 1, 1), ErrorCode::bad_option);
    }
  for (const double size : {-1.0, infinity, std::nan("")})
    EXPECT_EQ(code_of(box, size, 1), ErrorCode::bad_option);
  for (const std::int32_t margin : {0, -1}) EXPECT_EQ(code_of(box, 1, margin), ErrorCode::bad_option);
  EXPECT_EQ(code_of(box, 1e-9, 1), ErrorCode::too_large);
}

}  // namespace
}  // namespace certet
