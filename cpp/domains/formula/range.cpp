// The only translation unit that includes boost's interval arithmetic.

#include "range.hpp"

#include <algorithm>
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <initializer_list>

namespace certet {
namespace {

namespace bounds = boost::numeric::interval_lib;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Four units in the last place outwards: twice what the C library may err.
double down(double value) {
  if (std::isinf(value)) return std::min(value, std::numeric_limits<double>::max());
  return value - (std::abs(value) * 0x1p-50 + 0x1p-1072);
}
double up(double value) { return -down(-value); }

/// Rounding as points have it: to nearest.
using Nearest = boost::numeric::interval<
    double, bounds::policies<bounds::save_state_nothing<bounds::rounded_arith_exact<double>>,
                             bounds::checking_base<double>>>;

/// For the periodic functions: all of their steps are rounded outwards.
struct OutwardRounding {
  static double add_down(double a, double b) { return down(a + b); }
  static double add_up(double a, double b) { return up(a + b); }
  static double sub_down(double a, double b) { return down(a - b); }
  static double sub_up(double a, double b) { return up(a - b); }
  static double mul_down(double a, double b) { return down(a * b); }
  static double mul_up(double a, double b) { return up(a * b); }
  static double div_down(double a, double b) { return down(a / b); }
  static double div_up(double a, double b) { return up(a / b); }
  static double int_down(double a) { return std::floor(a); }
  static double cos_down(double a) { return down(std::cos(a)); }
  static double cos_up(double a) { return up(std::cos(a)); }
  static double tan_down(double a) { return down(std::tan(a)); }
  static double tan_up(double a) { return up(std::tan(a)); }
  using unprotected_rounding = OutwardRounding;
};
using Outward =
    boost::numeric::interval<double,
                             bounds::policies<OutwardRounding, bounds::checking_base<double>>>;

/// Bounds that contain NaN say that numbers without a value may come up.
Range range(double low, double high) {
  return low <= high ? Range{low, high, false} : Range{};
}
template <class Interval>
Range range(const Interval& interval) {
  return range(interval.lower(), interval.upper());
}

Nearest nearest(const Range& a) { return {a.low, a.high}; }
Outward outward(const Range& a) { return {a.low, a.high}; }

bool holds(const Range& a, double value) { return a.low <= value && value <= a.high; }
bool is_infinite(const Range& a) { return std::isinf(a.low) || std::isinf(a.high); }
bool is_number(const Range& a, double value) { return a.low == value && a.high == value; }

/// A function that ascends, as the C library computes it.  It never goes beyond
/// `least`, and keeps the sign of its operand if it is odd.
template <class Function>
Range ascending(const Function& function, const Range& a, double least = -infinity) {
  return range(std::max(down(function(a.low)), least), up(function(a.high)));
}
template <class Function>
Range odd(const Function& function, const Range& a) {
  Range result = ascending(function, a);
  if (a.low >= 0) result.low = std::max(result.low, 0.0);
  if (a.high <= 0) result.high = std::min(result.high, 0.0);
  return result;
}
/// One that ascends and is computed without error.
template <class Function>
Range exactly(const Function& function, const Range& a) {
  return range(function(a.low), function(a.high));
}

/// Where all extremes are at the corners of the operands' box.
template <class Function>
Range of_corners(const Function& function, const Range& a, const Range& b) {
  const auto corners = {function(a.low, b.low), function(a.low, b.high),
                        function(a.high, b.low), function(a.high, b.high)};
  if (std::ranges::any_of(corners, [](double c) { return std::isnan(c); })) return {};
  return range(down(std::min(corners)), up(std::max(corners)));
}

Range periodic(const Outward& result, const Range& a) {
  return is_infinite(a) ? Range{} : range(result);
}

Range logarithm(double (*function)(double), const Range& a) {
  return a.low < 0 ? Range{} : ascending(function, a);
}

Range sum(const Range& a, const Range& b) {
  const bool opposite_infinities = (a.low == -infinity && b.high == infinity) ||
                                   (a.high == infinity && b.low == -infinity);
  return opposite_infinities ? Range{} : range(nearest(a) + nearest(b));
}

Range negative(const Range& a) { return range(-a.high, -a.low); }

Range product(const Range& a, const Range& b, bool same) {
  if (same) return range(square(nearest(a)));
  const bool zero_times_infinity =
      (holds(a, 0) && is_infinite(b)) || (holds(b, 0) && is_infinite(a));
  return zero_times_infinity ? Range{} : range(nearest(a) * nearest(b));
}

/// A divisor of 0 may be -0, so that both infinities come up.
Range quotient(const Range& a, const Range& b) {
  if (is_infinite(a) && is_infinite(b)) return {};
  if (holds(b, 0)) return holds(a, 0) ? Range{} : Range{-infinity, infinity, false};
  return range(nearest(a) / nearest(b));
}

Range integer_power(const Range& a, double exponent) {
  const auto function = [exponent](double base) { return std::pow(base, exponent); };
  if (exponent < 0) {
    if (holds(a, 0)) return {};
    return of_corners([](double base, double power) { return std::pow(base, power); }, a,
                      {exponent, exponent, false});
  }
  if (std::fmod(exponent, 2) != 0) return odd(function, a);
  const Nearest magnitude = abs(nearest(a));
  return ascending(function, range(magnitude), 0);
}

/// Powers that are not whole are those of a positive base.
Range power(const Range& a, const Range& b) {
  if (b.low == b.high && std::floor(b.low) == b.low && !is_infinite(b))
    return integer_power(a, b.low);
  if (a.low < 0 || (a.low == 0 && b.low <= 0) || is_infinite(b)) return {};
  Range result = of_corners([](double base, double exponent) { return std::pow(base, exponent); },
                            a, b);
  if (!result.may_be_nan) result.low = std::max(result.low, 0.0);
  return result;
}

/// The angle jumps where y changes its sign at a negative x.
Range angle(const Range& y, const Range& x) {
  if (is_infinite(y) || is_infinite(x)) return {};
  const auto function = [](double a, double b) { return std::atan2(a, b); };
  if (holds(y, 0) && x.low <= 0) return {-3.2, 3.2, false};
  return of_corners(function, y, x);
}

/// fmod: of a's sign, and less than either.
Range remainder(const Range& a, const Range& b) {
  if (is_infinite(a) || holds(b, 0)) return {};
  const double most = std::min(std::max(-a.low, a.high), std::max(-b.low, b.high));
  return range(a.low < 0 ? -most : 0.0, a.high > 0 ? most : 0.0);
}

Range either(const Range& a, const Range& b) {
  if (a.may_be_nan || b.may_be_nan) return {};
  return range(std::min(a.low, b.low), std::max(a.high, b.high));
}

/// What is known of a condition.
enum class Truth { no, yes, unknown };

Truth truth(const Range& a) {
  if (a.may_be_nan) return Truth::unknown;
  if (is_number(a, 0)) return Truth::no;
  return holds(a, 0) ? Truth::unknown : Truth::yes;
}

Range range(Truth truth) {
  return range(truth == Truth::yes ? 1.0 : 0.0, truth == Truth::no ? 0.0 : 1.0);
}

Truth negation(Truth a) {
  if (a == Truth::unknown) return a;
  return a == Truth::yes ? Truth::no : Truth::yes;
}

Truth conjunction(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::unknown;
}

Truth less(const Range& a, const Range& b) {
  if (a.may_be_nan || b.may_be_nan) return Truth::unknown;
  if (a.high < b.low) return Truth::yes;
  return a.low >= b.high ? Truth::no : Truth::unknown;
}

/// Where one of them may be NaN, a <= b is not the contrary of b < a.
Truth less_equal(const Range& a, const Range& b) { return negation(less(b, a)); }

Truth equal(const Range& a, const Range& b) {
  if (a.may_be_nan || b.may_be_nan) return Truth::unknown;
  if (a.high < b.low || b.high < a.low) return Truth::no;
  return is_number(a, b.low) && is_number(b, a.low) ? Truth::yes : Truth::unknown;
}

Range sign(const Range& a) {
  if (a.may_be_nan) return {-1, 1, false};
  return range(double(a.low > 0) - double(a.low < 0), double(a.high > 0) - double(a.high < 0));
}

Range select(const Range& condition, const Range& a, const Range& b) {
  switch (truth(condition)) {
    case Truth::yes: return a;
    case Truth::no: return b;
    default: return either(a, b);
  }
}

Range of_one(Operation operation, const Range& a) {
  const bool in_unit = a.low >= -1 && a.high <= 1;
  switch (operation) {
    case Operation::negate: return negative(a);
    case Operation::absolute: return range(abs(nearest(a)));
    case Operation::floor: return exactly([](double v) { return std::floor(v); }, a);
    case Operation::ceil: return exactly([](double v) { return std::ceil(v); }, a);
    case Operation::round: return exactly([](double v) { return std::round(v); }, a);
    case Operation::truncate: return exactly([](double v) { return std::trunc(v); }, a);
    case Operation::square_root: return a.low < 0 ? Range{} : range(sqrt(nearest(a)));
    case Operation::exp: return ascending([](double v) { return std::exp(v); }, a, 0);
    case Operation::log: return logarithm(std::log, a);
    case Operation::log2: return logarithm(std::log2, a);
    case Operation::log10: return logarithm(std::log10, a);
    case Operation::sin: return periodic(sin(outward(a)), a);
    case Operation::cos: return periodic(cos(outward(a)), a);
    case Operation::tan: return periodic(tan(outward(a)), a);
    case Operation::asin:
      return in_unit ? odd([](double v) { return std::asin(v); }, a) : Range{};
    case Operation::acos:
      return in_unit ? negative(ascending([](double v) { return -std::acos(v); }, a)) : Range{};
    case Operation::atan: return odd([](double v) { return std::atan(v); }, a);
    case Operation::sinh: return odd([](double v) { return std::sinh(v); }, a);
    case Operation::cosh:
      return ascending([](double v) { return std::cosh(v); }, range(abs(nearest(a))), 0);
    case Operation::tanh: return odd([](double v) { return std::tanh(v); }, a);
    case Operation::asinh: return odd([](double v) { return std::asinh(v); }, a);
    case Operation::acosh:
      return a.low >= 1 ? ascending([](double v) { return std::acosh(v); }, a, 0) : Range{};
    case Operation::atanh:
      return in_unit ? odd([](double v) { return std::atanh(v); }, a) : Range{};
    default: return {};
  }
}

Range of_two(Operation operation, const Range& a, const Range& b, bool same) {
  switch (operation) {
    case Operation::add: return sum(a, b);
    case Operation::subtract: return sum(a, negative(b));
    case Operation::multiply: return product(a, b, same);
    case Operation::divide: return quotient(a, b);
    case Operation::power: return power(a, b);
    case Operation::minimum: return range(min(nearest(a), nearest(b)));
    case Operation::maximum: return range(max(nearest(a), nearest(b)));
    case Operation::atan2: return angle(a, b);
    case Operation::remainder: return remainder(a, b);
    default: return {};
  }
}

/// Those that make a number of NaN.
bool decides(Operation operation) {
  return operation == Operation::sign || operation == Operation::logical_not ||
         operation >= Operation::less;
}

Range decision(Operation operation, std::span<const Range> of) {
  switch (operation) {
    case Operation::sign: return sign(of[0]);
    case Operation::logical_not: return range(negation(truth(of[0])));
    case Operation::less: return range(less(of[0], of[1]));
    case Operation::less_equal: return range(less_equal(of[0], of[1]));
    case Operation::greater: return range(less(of[1], of[0]));
    case Operation::greater_equal: return range(less_equal(of[1], of[0]));
    case Operation::equal: return range(equal(of[0], of[1]));
    case Operation::unequal: return range(negation(equal(of[0], of[1])));
    case Operation::logical_and: return range(conjunction(truth(of[0]), truth(of[1])));
    case Operation::logical_or:
      return range(negation(conjunction(negation(truth(of[0])), negation(truth(of[1])))));
    default: return select(of[0], of[1], of[2]);
  }
}

}  // namespace

Range range_of(Operation operation, std::span<const Range> operands, bool same) {
  if (decides(operation)) return decision(operation, operands);
  if (std::ranges::any_of(operands, &Range::may_be_nan)) return {};
  return operands.size() == 1 ? of_one(operation, operands[0])
                              : of_two(operation, operands[0], operands[1], same);
}

}  // namespace certet
