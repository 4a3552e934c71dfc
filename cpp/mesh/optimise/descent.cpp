#include "descent.hpp"

#include <algorithm>

namespace certet::optimising {

/// Gilbert's algorithm: on towards the gradient that is least along what was found, as far as the
/// nearest point to 0.
Vector shortest_in_hull(std::span<const Vector> gradients) {
  constexpr int turns = 24;
  constexpr double near_enough = 0.02;
  Vector shortest = gradients.front();
  for (int turn = 0; turn < turns; ++turn) {
    const Vector& least = *std::ranges::min_element(
        gradients, {}, [&](const Vector& g) { return dot(g, shortest); });
    const Vector towards = least - shortest;
    const double gain = -dot(towards, shortest), extent = dot(towards, towards);
    if (gain <= near_enough * dot(shortest, shortest) || extent == 0) break;
    shortest = shortest + std::min(1.0, gain / extent) * towards;
  }
  return shortest;
}

}  // namespace certet::optimising
