#pragma once
/// \file
/// Formulas of any operations, over boxes of any size.

#include <array>
#include <limits>
#include <random>
#include <vector>

#include "range.hpp"
#include "seed.hpp"
#include "tape.hpp"

namespace random_formula {

using certet::NodeId;
using certet::Operation;
using Random = std::mt19937_64;

inline double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Often a number at which a function turns, jumps or ends.
inline double constant(Random& random) {
  constexpr std::array special{0.0, -0.0, 1.0,  -1.0, 2.0, -2.0,  3.0,   4.0,
                               0.5, -3.0, 1e-9, 1e9,  710.0, -745.0, 1e300, 5.0};
  if (between(random, 0, 2) == 0) return real(random, -3, 3);
  return special[static_cast<std::size_t>(between(random, 0, int{special.size()} - 1))];
}

/// A tape that ends in `root`, and has the variables as nodes 0, 1 and 2.
struct Formula {
  certet::Tape tape;
  NodeId root = 0;
};

inline Formula formula(Random& random, int operations) {
  Formula result;
  std::vector<NodeId> nodes;
  for (std::size_t axis = 0; axis < 3; ++axis) nodes.push_back(result.tape.variable(axis));
  for (int i = 0; i < 3; ++i) nodes.push_back(result.tape.constant(constant(random)));
  const auto any = [&] {  // late nodes often, so that formulas become deep
    const auto last = static_cast<std::int32_t>(nodes.size()) - 1;
    return nodes[static_cast<std::size_t>(
        between(random, between(random, 0, 1) * std::max(0, last - 4), last))];
  };
  for (int i = 0; i < operations; ++i) {
    const auto operation = static_cast<Operation>(
        between(random, static_cast<int>(Operation::negate),
                static_cast<int>(Operation::select)));
    const NodeId a = any(), b = any(), c = any();
    const int count = certet::operands_of(operation);
    nodes.push_back(result.tape.add(operation, a, count > 1 ? b : 0, count > 2 ? c : 0));
  }
  result.root = static_cast<NodeId>(result.tape.nodes().size() - 1);
  return result;
}

using Box = std::array<certet::Range, 3>;

/// From a point to hundreds wide; sides often begin or end at a whole number.
inline Box box(Random& random) {
  Box result;
  for (certet::Range& side : result) {
    const double width = std::pow(10.0, between(random, -6, 2)) * between(random, 0, 1);
    double low = real(random, -4, 4);
    if (between(random, 0, 1)) low = std::round(low);
    side = {low, low + width, false};
    if (between(random, 0, 1)) side = {-side.high, -side.low, false};
  }
  return result;
}

/// Corners, points on the sides, and points within.
inline certet::Point3 point(Random& random, const Box& box) {
  certet::Point3 result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const certet::Range& side = box[axis];
    const double within = std::clamp(real(random, 0, 1) * (side.high - side.low) + side.low,
                                     side.low, side.high);
    const std::array choices{side.low, side.high, within, within};
    result[axis] = choices[static_cast<std::size_t>(between(random, 0, 3))];
  }
  return result;
}

}  // namespace random_formula
