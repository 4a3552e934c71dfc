#pragma once
/// \file
/// The functions that a formula may call.

#include <span>

#include "tape.hpp"

namespace certet {

/// `operands` is 1, 2 or 3, or `any_number` of at least one.
struct FormulaFunction {
  const char* name;
  int operands;
  NodeId (*record)(Tape& tape, std::span<const NodeId> operands);
};

inline constexpr int any_number = 0;

std::span<const FormulaFunction> formula_functions();

/// a^b.  The second to fourth powers are multiplied out, from the left.
NodeId record_power(Tape& tape, NodeId base, NodeId exponent);

}  // namespace certet
