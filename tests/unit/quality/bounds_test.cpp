/// Holding measured angles to the proven bounds.

#include <gtest/gtest.h>

#include <cmath>

#include "certet/quality.hpp"

namespace certet {
namespace {

Quality measured(double least, double greatest) {
  Quality quality;
  quality.tets = 1;
  quality.min_dihedral = least;
  quality.max_dihedral = greatest;
  return quality;
}

TEST(ProvenBounds, HoldOrDoNot) {
  for (const AngleBounds& b : {proven_bounds(Cuts::bisect, Guarantee::angles),
                               proven_bounds(Cuts::bisect, Guarantee::embedding),
                               proven_bounds(Cuts::midpoint, Guarantee::angles)}) {
    EXPECT_TRUE(within(measured(b.min_dihedral, b.max_dihedral), b, 0));
    EXPECT_FALSE(within(measured(b.min_dihedral - 0.001, b.max_dihedral), b, 1e-6));
    EXPECT_FALSE(within(measured(b.min_dihedral, b.max_dihedral + 0.001), b, 1e-6));
    EXPECT_TRUE(within(measured(b.min_dihedral - 1e-9, b.max_dihedral + 1e-9), b, 1e-6));
    EXPECT_FALSE(within(measured(std::nan(""), b.max_dihedral), b, 1e-6));
  }
}

TEST(ProvenBounds, AnInvertedTetrahedronIsOutsideOfAny) {
  const AngleBounds b = proven_bounds(Cuts::bisect, Guarantee::angles);
  Quality quality = measured(60, 90);
  EXPECT_TRUE(within(quality, b, 0));
  quality.nonpositive = 1;
  EXPECT_FALSE(within(quality, b, 0));
}

}  // namespace
}  // namespace certet
