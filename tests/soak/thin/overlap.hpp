#pragma once
/// \file
/// Whether tetrahedra overlap, exactly.

#include <cstdint>
#include <vector>

#include "property/exact.hpp"

namespace thin {

/// How many pairs of tetrahedra have a point inside both, and how many had boxes that
/// overlap and were looked at.  Coordinates are in steps, and no tetrahedron is longer
/// than four lattice units.
struct Overlaps {
  std::uint64_t found = 0, looked_at = 0;
};
Overlaps overlaps(const std::vector<exact::Tet>& tets);

}  // namespace thin
