/// \file
/// A constant by which one value decides a block.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "certet/lattice.hpp"
#include "certet/function_domain.hpp"
#include "distances.hpp"
#include "extents.hpp"

namespace {

using certet::FunctionDomain;
using certet::Point3;

const certet::Bounds around{{-1.7, -1.5, -1.6}, {1.5, 1.7, 1.6}};

/// Balls of all sizes, everywhere in the bounds, whose function changes by
/// `slope` per world unit.
struct Ball {
  Point3 centre;
  double radius, slope;
  double operator()(const Point3& p) const {
    const double x = p[0] - centre[0], y = p[1] - centre[1], z = p[2] - centre[2];
    return slope * (std::sqrt(x * x + y * y + z * z) - radius);
  }
};

/// Blocks of many balls, with a constant `declared` times the true one.
std::string found_with(double declared, int& decided) {
  std::mt19937_64 random(test_seed());
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 60; ++i) {
    const Ball ball{{real(-1, 1), real(-1, 1), real(-1, 1)}, real(0.1, 1.5), real(0.1, 9)};
    certet::PlacedLattice lattice = certet::lattice_around(around, real(0.05, 0.12), 2);
    if (i % 2 == 1) lattice.frame.axes = {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}};
    const FunctionDomain domain(ball, lattice.frame, declared * ball.slope);
    std::string found =
        extents::first_contradiction(random, domain, lattice.lattice, 100, decided);
    if (!found.empty()) return found;
  }
  return "";
}

TEST(Lipschitz, NoBlockIsDecidedWrongly) {
  int decided = 0;
  EXPECT_EQ(found_with(1, decided), "");
  EXPECT_GT(decided, 1000);
}

TEST(Lipschitz, AConstantThatIsTooSmallIsFound) {
  int decided = 0;
  EXPECT_NE(found_with(0.8, decided), "");
}

TEST(Lipschitz, WithoutAConstantNothingIsDecided) {
  int decided = 0;
  EXPECT_EQ(found_with(std::numeric_limits<double>::infinity(), decided), "");
  EXPECT_EQ(decided, 0);
}

TEST(Lipschitz, ValuesWithoutANumberDecideNothing) {
  const auto lattice = certet::lattice_around(around, 0.1, 2);
  const FunctionDomain domain([](Point3) { return std::nan(""); }, lattice.frame, 1);
  EXPECT_EQ(domain.extent({{-8, -8, -8}, {8, 8, 8}}), certet::Extent::mixed);
}

}  // namespace
