/// \file
/// What intervals say of a box is never contradicted by a point of it.

#include "range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "certet/formula.hpp"
#include "extents.hpp"
#include "random_formula.hpp"

namespace {

using certet::Operation;
using certet::Range;
using random_formula::Random;

/// A node of a random formula whose value leaves its range, in words.
std::string contradiction(Random& random, certet::RangeRule rule) {
  const auto [tape, root] = random_formula::formula(random, between(random, 1, 12));
  const auto box = random_formula::box(random);
  const std::vector<Range> ranges = certet::ranges(tape, root, box, rule);
  for (int trial = 0; trial < 30; ++trial) {
    const certet::Point3 point = random_formula::point(random, box);
    for (certet::NodeId id = 0; id <= root; ++id) {
      const double value = tape.evaluate(id, point);
      const bool holds = std::isnan(value) ? ranges[id].may_be_nan
                                           : ranges[id].low <= value && value <= ranges[id].high;
      if (!holds)
        return "operation " + std::to_string(static_cast<int>(tape[id].operation)) + " gives " +
               std::to_string(value) + " outside of " + std::to_string(ranges[id].low) + " to " +
               std::to_string(ranges[id].high);
    }
  }
  return "";
}

std::string first_contradiction(certet::RangeRule rule, int formulas) {
  Random random(test_seed());
  for (int i = 0; i < formulas; ++i)
    if (std::string found = contradiction(random, rule); !found.empty()) return found;
  return "";
}

TEST(FormulaRange, HoldsForEveryPoint) {
  EXPECT_EQ(first_contradiction(certet::range_of, 20'000), "");
}

/// Every operation must be able to fail: the planted rule is a little too tight,
/// or forgets a case, and the same search finds it.
template <Operation planted>
Range too_tight(Operation operation, std::span<const Range> of, bool same) {
  Range range = certet::range_of(operation, of, same);
  if (operation != planted) return range;
  if (range.may_be_nan) return {-1e308, 1e308, false};
  const double tenth = 0.1 * std::min(range.high - range.low, 1.0);
  return {range.low + tenth, range.high - 2 * tenth, false};
}

template <int... number>
void expect_all_caught(std::integer_sequence<int, number...>) {
  constexpr int first = static_cast<int>(Operation::negate);
  const auto expect_caught = [](certet::RangeRule rule, int operation) {
    EXPECT_NE(first_contradiction(rule, 20'000), "") << "operation " << operation;
  };
  (expect_caught(too_tight<static_cast<Operation>(first + number)>, first + number), ...);
}

TEST(FormulaRange, TheSearchFindsEveryRuleThatIsTooTight) {
  constexpr int count = static_cast<int>(Operation::select) - static_cast<int>(Operation::negate);
  expect_all_caught(std::make_integer_sequence<int, count + 1>());
}

/// Bounds by the ends alone: right for what ascends, wrong where there is an
/// extreme within.
Range by_the_ends(Operation operation, std::span<const Range> of, bool same) {
  if (operation == Operation::sin && !of[0].may_be_nan) {
    const double a = std::sin(of[0].low), b = std::sin(of[0].high);
    return {std::min(a, b), std::max(a, b), false};
  }
  return certet::range_of(operation, of, same);
}

TEST(FormulaRange, AForgottenExtremeIsFound) {
  EXPECT_NE(first_contradiction(by_the_ends, 20'000), "");
}

TEST(FormulaRange, IsTightEnoughToBeOfUse) {
  certet::Tape tape;
  const auto x = tape.variable(0), y = tape.variable(1);
  const auto squares = tape.add(Operation::add, tape.add(Operation::multiply, x, x),
                                tape.add(Operation::multiply, y, y));
  const auto root = tape.add(Operation::square_root, squares);
  const auto found = certet::ranges(tape, root, {Range{-1, 3, false}, {-4, 1, false}, {}});
  EXPECT_EQ(found[root].low, 0);
  EXPECT_EQ(found[root].high, 5);
  EXPECT_FALSE(found[root].may_be_nan);
}

TEST(FormulaDomain, ExtentAgreesWithRows) {
  const char* const formulas[] = {
      "(sqrt(x^2+y^2)-1)^2+z^2-0.16",
      "max(abs(x),abs(y),abs(z))-0.5",
      "sin(2*x)*cos(2*y)+sin(2*y)*cos(2*z)+sin(2*z)*cos(2*x)",
      "sqrt(x)-0.7+y^2+z^2",
      "z<0 ? x^2+y^2-1 : x^4+y^4+z^4-1",
      "-log(exp(-8*(hypot(x-0.5,y,z)-0.6))+exp(-8*(hypot(x+0.5,y,z)-0.6)))/8",
      "1/(x*y)-z",
      "-1"};
  Random random(test_seed());
  for (const char* formula : formulas) {
    const certet::FormulaDomain domain(formula, {{-1.5, -1.4, -1.3}, {1.5, 1.6, 1.7}}, 0.06, 2);
    int decided = 0;
    EXPECT_EQ(extents::first_contradiction(random, domain, domain.lattice(), 300, decided), "")
        << formula;
    EXPECT_GT(decided, 20) << formula;
  }
}

}  // namespace
