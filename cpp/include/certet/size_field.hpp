#pragma once
/// \file
/// How large tetrahedra may be, place by place.

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "certet/frame.hpp"
#include "certet/grading.hpp"

namespace certet {

/// The greatest long edges that are wanted, in world units.
struct SizeField {
  std::string name;  ///< what sentences call it, like: formula 'x + 1'
  /// Writes the size that is wanted at each of some points of the world.  It is asked for centres
  /// of cells inside the shape alone, from several threads, and must give the same answer for
  /// the same point every time.
  std::function<void(std::span<const Point3> points, std::span<double> sizes)> at;
};

/// By how many levels, of most_grading_levels, long edges of this size stay within `greatest`.
std::int32_t levels_within(double greatest, double size);

/// Grades a mesh in this frame no more than sizes allow at the centre of each cell; by
/// `levels` at most, as ever, and nowhere finer than the lattice.  `Stuffing::grade` then throws
/// Error `bad_input`, with one sentence that names the point, where a size is not positive.
void keep_within(SizeField sizes, const Frame& frame, Grading& grading);

}  // namespace certet
