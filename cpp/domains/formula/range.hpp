#pragma once
/// \file
/// A formula over a whole box at once, in interval arithmetic.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "tape.hpp"

namespace certet {

/// All numbers that an operation may compute, in floating point as it is computed,
/// lie in [low, high].  What may be NaN may be anything: its bounds are infinite.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool may_be_nan = true;
};

/// The range of an operation whose operands have these ranges.  `same`: the first
/// two operands are the same number.
///
/// Sums, products, quotients and square roots are rounded to nearest by points and
/// bounds alike, and rounding is monotone, so that bounds computed like points
/// hold for points exactly.  Of the C library's functions it is assumed that they
/// err by at most two units in the last place; their bounds are computed outwards
/// of the true ones by more than that.
Range range_of(Operation operation, std::span<const Range> operands, bool same);

using RangeRule = Range (*)(Operation operation, std::span<const Range> operands, bool same);

/// The ranges of all nodes, up to `root`, where x, y and z have the ranges of `box`.
/// Where interval arithmetic was not built in, all that is not a leaf may be NaN.
std::vector<Range> ranges(const Tape& tape, NodeId root, const std::array<Range, 3>& box,
                          RangeRule rule = range_of);

}  // namespace certet
