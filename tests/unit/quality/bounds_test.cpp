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
  for (const MethodFacts& method : methods) {
    const AngleBounds& b = method.bounds;
    EXPECT_TRUE(within(measured(b.min_dihedral, b.max_dihedral), b, 0));
    EXPECT_FALSE(within(measured(b.min_dihedral - 0.001, b.max_dihedral), b, 1e-6));
    EXPECT_FALSE(within(measured(b.min_dihedral, b.max_dihedral + 0.001), b, 1e-6));
    EXPECT_TRUE(within(measured(b.min_dihedral - 1e-9, b.max_dihedral + 1e-9), b, 1e-6));
    EXPECT_FALSE(within(measured(std::nan(""), b.max_dihedral), b, 1e-6));
  }
}

TEST(ProvenBounds, AnInvertedTetrahedronIsOutsideOfAny) {
  const AngleBounds b = facts(Method::angles).bounds;
  Quality quality = measured(60, 90);
  EXPECT_TRUE(within(quality, b, 0));
  quality.nonpositive = 1;
  EXPECT_FALSE(within(quality, b, 0));
}

/// To half a thousandth of a degree, as tables round.
TEST(AngleDefect, JudgesWhatIsShown) {
  const AngleBounds b{30, 135, {}};
  EXPECT_EQ(angle_defect(measured(30, 135), b, "x"), "");
  EXPECT_EQ(angle_defect(measured(29.99951, 135.00049), b, "x"), "");
  EXPECT_EQ(angle_defect(measured(29.9994, 90), b, "x"),
            "the dihedral angles are from 29.999 to 90 degrees, outside of the 30 to 135 of x");
  EXPECT_NE(angle_defect(measured(60, 135.0006), b, "x"), "");
  EXPECT_NE(angle_defect(measured(std::nan(""), 90), b, "x"), "");
  // Without a positive tetrahedron there are no angles.
  Quality none = measured(180, 0);
  none.nonpositive = none.tets;
  EXPECT_EQ(angle_defect(none, b, "x"), "");
}

}  // namespace
}  // namespace certet
