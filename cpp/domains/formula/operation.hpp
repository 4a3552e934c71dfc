#pragma once
/// \file
/// What a formula is made of, and what each operation does to numbers.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace certet {

enum class Operation : std::uint8_t {
  // Leaves.
  constant, x, y, z,
  // Of one operand.
  negate, absolute, sign, floor, ceil, round, truncate, square_root,
  exp, log, log2, log10, sin, cos, tan, asin, acos, atan,
  sinh, cosh, tanh, asinh, acosh, atanh, logical_not,
  // Of two operands.
  add, subtract, multiply, divide, power, minimum, maximum, atan2, remainder,
  less, less_equal, greater, greater_equal, equal, unequal, logical_and, logical_or,
  // Of three operands.
  select,
};

constexpr int operands_of(Operation operation) {
  if (operation < Operation::negate) return 0;
  if (operation < Operation::add) return 1;
  return operation < Operation::select ? 2 : 3;
}

/// Calls `visit` with the operation as a function of as many numbers as it has
/// operands: the only place that says what an operation computes.  Truth is 1,
/// and all but 0 is true, NaN too.  No branches where there need not be, so that
/// loops over arrays vectorise.
template <class Visit>
void with_function(Operation operation, const Visit& visit) {
  switch (operation) {
    case Operation::constant: case Operation::x: case Operation::y: case Operation::z: return;
    case Operation::negate: return visit([](double a) { return -a; });
    case Operation::absolute: return visit([](double a) { return std::abs(a); });
    case Operation::sign: return visit([](double a) { return double(a > 0) - double(a < 0); });
    case Operation::floor: return visit([](double a) { return std::floor(a); });
    case Operation::ceil: return visit([](double a) { return std::ceil(a); });
    case Operation::round: return visit([](double a) { return std::round(a); });
    case Operation::truncate: return visit([](double a) { return std::trunc(a); });
    case Operation::square_root: return visit([](double a) { return std::sqrt(a); });
    case Operation::exp: return visit([](double a) { return std::exp(a); });
    case Operation::log: return visit([](double a) { return std::log(a); });
    case Operation::log2: return visit([](double a) { return std::log2(a); });
    case Operation::log10: return visit([](double a) { return std::log10(a); });
    case Operation::sin: return visit([](double a) { return std::sin(a); });
    case Operation::cos: return visit([](double a) { return std::cos(a); });
    case Operation::tan: return visit([](double a) { return std::tan(a); });
    case Operation::asin: return visit([](double a) { return std::asin(a); });
    case Operation::acos: return visit([](double a) { return std::acos(a); });
    case Operation::atan: return visit([](double a) { return std::atan(a); });
    case Operation::sinh: return visit([](double a) { return std::sinh(a); });
    case Operation::cosh: return visit([](double a) { return std::cosh(a); });
    case Operation::tanh: return visit([](double a) { return std::tanh(a); });
    case Operation::asinh: return visit([](double a) { return std::asinh(a); });
    case Operation::acosh: return visit([](double a) { return std::acosh(a); });
    case Operation::atanh: return visit([](double a) { return std::atanh(a); });
    case Operation::logical_not: return visit([](double a) { return double(a == 0); });
    case Operation::add: return visit([](double a, double b) { return a + b; });
    case Operation::subtract: return visit([](double a, double b) { return a - b; });
    case Operation::multiply: return visit([](double a, double b) { return a * b; });
    case Operation::divide: return visit([](double a, double b) { return a / b; });
    case Operation::power: return visit([](double a, double b) { return std::pow(a, b); });
    case Operation::minimum: return visit([](double a, double b) { return b < a ? b : a; });
    case Operation::maximum: return visit([](double a, double b) { return a < b ? b : a; });
    case Operation::atan2: return visit([](double a, double b) { return std::atan2(a, b); });
    case Operation::remainder: return visit([](double a, double b) { return std::fmod(a, b); });
    case Operation::less: return visit([](double a, double b) { return double(a < b); });
    case Operation::less_equal: return visit([](double a, double b) { return double(a <= b); });
    case Operation::greater: return visit([](double a, double b) { return double(a > b); });
    case Operation::greater_equal:
      return visit([](double a, double b) { return double(a >= b); });
    case Operation::equal: return visit([](double a, double b) { return double(a == b); });
    case Operation::unequal: return visit([](double a, double b) { return double(a != b); });
    case Operation::logical_and:
      return visit([](double a, double b) { return double((a != 0) & (b != 0)); });
    case Operation::logical_or:
      return visit([](double a, double b) { return double((a != 0) | (b != 0)); });
    case Operation::select:
      return visit([](double c, double a, double b) { return c != 0 ? a : b; });
  }
}

}  // namespace certet
