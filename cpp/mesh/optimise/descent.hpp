#pragma once
/// \file
/// A direction in which several functions fall at once.

#include <span>

#include "vector.hpp"

namespace certet::optimising {

/// About the shortest vector in the convex hull of some gradients, of which there is one at
/// least; where it is 0 there is no direction in which all functions fall, and elsewhere all do
/// so against it, each by its length at least.
Vector shortest_in_hull(std::span<const Vector> gradients);

}  // namespace certet::optimising
