#include "functions.hpp"

#include <array>

namespace certet {
namespace {

using Operands = std::span<const NodeId>;

template <Operation operation>
NodeId one(Tape& tape, Operands of) {
  return tape.add(operation, of[0]);
}

template <Operation operation>
NodeId two(Tape& tape, Operands of) {
  return tape.add(operation, of[0], of[1]);
}

/// From the left: f(f(a,b),c).
template <Operation operation>
NodeId fold(Tape& tape, Operands of) {
  NodeId result = of[0];
  for (const NodeId next : of.subspan(1)) result = tape.add(operation, result, next);
  return result;
}

/// muParser's: halves go up.
NodeId nearest(Tape& tape, Operands of) {
  return tape.add(Operation::floor, tape.add(Operation::add, of[0], tape.constant(0.5)));
}

NodeId raise(Tape& tape, Operands of) { return record_power(tape, of[0], of[1]); }

NodeId average(Tape& tape, Operands of) {
  return tape.add(Operation::divide, fold<Operation::add>(tape, of),
                  tape.constant(static_cast<double>(of.size())));
}

NodeId length(Tape& tape, Operands of) {
  NodeId sum = tape.add(Operation::multiply, of[0], of[0]);
  for (const NodeId next : of.subspan(1))
    sum = tape.add(Operation::add, sum, tape.add(Operation::multiply, next, next));
  return tape.add(Operation::square_root, sum);
}

NodeId clamp(Tape& tape, Operands of) {
  return tape.add(Operation::maximum, of[1], tape.add(Operation::minimum, of[0], of[2]));
}

/// a where t is 0, b where it is 1, exactly.
NodeId mix(Tape& tape, Operands of) {
  const NodeId rest = tape.add(Operation::subtract, tape.constant(1), of[2]);
  return tape.add(Operation::add, tape.add(Operation::multiply, of[0], rest),
                  tape.add(Operation::multiply, of[1], of[2]));
}

NodeId choose(Tape& tape, Operands of) {
  return tape.add(Operation::select, of[0], of[1], of[2]);
}

constexpr auto functions = [] {
  using enum Operation;
  return std::to_array<FormulaFunction>({
      {"abs", 1, one<absolute>},
      {"sign", 1, one<sign>},
      {"floor", 1, one<floor>},
      {"ceil", 1, one<ceil>},
      {"round", 1, one<round>},
      {"trunc", 1, one<truncate>},
      {"rint", 1, nearest},
      {"sqrt", 1, one<square_root>},
      {"exp", 1, one<exp>},
      {"log", 1, one<log>},
      {"ln", 1, one<log>},
      {"log2", 1, one<log2>},
      {"log10", 1, one<log10>},
      {"sin", 1, one<sin>},
      {"cos", 1, one<cos>},
      {"tan", 1, one<tan>},
      {"asin", 1, one<asin>},
      {"acos", 1, one<acos>},
      {"atan", 1, one<atan>},
      {"sinh", 1, one<sinh>},
      {"cosh", 1, one<cosh>},
      {"tanh", 1, one<tanh>},
      {"asinh", 1, one<asinh>},
      {"acosh", 1, one<acosh>},
      {"atanh", 1, one<atanh>},
      {"not", 1, one<logical_not>},
      {"atan2", 2, two<atan2>},
      {"pow", 2, raise},
      {"fmod", 2, two<remainder>},
      {"clamp", 3, clamp},
      {"mix", 3, mix},
      {"if", 3, choose},
      {"min", any_number, fold<minimum>},
      {"max", any_number, fold<maximum>},
      {"sum", any_number, fold<add>},
      {"avg", any_number, average},
      {"hypot", any_number, length},
      {"length", any_number, length},
  });
}();

}  // namespace

std::span<const FormulaFunction> formula_functions() { return functions; }

NodeId record_power(Tape& tape, NodeId base, NodeId exponent) {
  const Node& node = tape[exponent];
  const bool few = node.operation == Operation::constant &&
                   (node.value == 2 || node.value == 3 || node.value == 4);
  if (!few) return tape.add(Operation::power, base, exponent);
  const int factors = static_cast<int>(node.value);
  NodeId product = base;
  for (int i = 1; i < factors; ++i) product = tape.add(Operation::multiply, product, base);
  return product;
}

}  // namespace certet
