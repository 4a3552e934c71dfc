#pragma once
/// \file
/// The size that gives a number of tetrahedra.

#include <cstdint>
#include <functional>

#include "certet/stuffing.hpp"
#include "source.hpp"

namespace certet::command {

/// A source on one lattice, and its mesh, counted but not written.
struct Counted {
  PlacedSource source;
  Stuffing stuffing;
};

/// Counts at several sizes, coarse ones first, and gives the count that comes
/// nearest to `target`: within a fiftieth of it, or the best of twelve.  The
/// sizes depend on the counts alone, so that the answer is always the same.
/// `longest_side` is the solid's, in world units; `tries` becomes the number of
/// counts.  Never holds two counts at a time.  \throws what `count_at` throws.
Counted count_near(std::uint64_t target, double longest_side,
                   const std::function<Counted(double size)>& count_at, int& tries);

}  // namespace certet::command
