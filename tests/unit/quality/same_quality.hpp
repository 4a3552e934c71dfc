#pragma once
/// \file
/// Figures of two measurements that must be the same to the last bit.

#include <gtest/gtest.h>

#include "certet/quality.hpp"

namespace certet {

inline void expect_same(const Quality& one, const Quality& other) {
  EXPECT_EQ(one.tets, other.tets);
  EXPECT_EQ(one.nonpositive, other.nonpositive);
  EXPECT_EQ(one.steps_volume, other.steps_volume);
  EXPECT_EQ(one.histogram, other.histogram);
  EXPECT_EQ(one.min_dihedral, other.min_dihedral);
  EXPECT_EQ(one.max_dihedral, other.max_dihedral);
}

}  // namespace certet
