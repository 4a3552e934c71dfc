#pragma once
/// \file
/// Vertices in an order in which many can move at once.
///
/// Space is divided into cubes, much wider than a tetrahedron, of eight colours: two of the same
/// never touch.  So vertices of different cubes of a colour have no tetrahedron in common, and
/// none of one is a neighbour of another one's neighbour: what becomes of them does not depend on
/// which moves first.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/lattice/coord3.hpp"

namespace certet::optimising {

/// Of the vertices of some cube.
struct Bucket {
  std::uint32_t begin, end;  ///< in `Buckets::order`
};

struct Buckets {
  std::vector<std::uint32_t> order;  ///< all vertices, bucket by bucket, by growing numbers in each
  std::vector<std::vector<Bucket>> colours;
};

/// Of vertices at these places, in steps.
Buckets buckets_of(std::span<const Coord3> places);

}  // namespace certet::optimising
