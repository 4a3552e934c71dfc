#pragma once
/// \file
/// Boxes of the world.

#include "certet/frame.hpp"

namespace certet {

/// A box along the axes of the world.
struct Bounds {
  Point3 low{}, high{};
};

/// In world units.
double longest_side(const Bounds& bounds);

}  // namespace certet
