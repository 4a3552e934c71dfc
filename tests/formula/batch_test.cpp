/// \file
/// Batches give what evaluating point by point gives, bit for bit.

#include "batch.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "random_formula.hpp"

namespace {

using certet::Batch;
using certet::batch_limit;
using random_formula::Random;

bool equal(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

/// Points of which some are expected to differ from the formula `expected`.
int differences(Random& random, const certet::Tape& tape, certet::NodeId computed,
                certet::NodeId expected, Batch kind) {
  const certet::BatchFormula batch(tape, computed, kind);
  certet::BatchFormula::Workspace workspace(batch);
  const auto box = random_formula::box(random);
  const auto count = static_cast<std::size_t>(between(random, 1, int{batch_limit}));
  std::array<std::array<double, batch_limit>, 3> at;
  for (std::size_t i = 0; i < count; ++i) {
    const certet::Point3 point = random_formula::point(random, box);
    for (std::size_t a = 0; a < 3; ++a)
      at[a][i] = kind == Batch::row && a > 0 && i > 0 ? at[a][0] : point[a];
  }
  std::array<double, batch_limit> values;
  batch.evaluate({at[0].data(), at[1].data(), at[2].data()}, count, workspace, values.data());
  int found = 0;
  for (std::size_t i = 0; i < count; ++i)
    found += !equal(values[i], tape.evaluate(expected, {at[0][i], at[1][i], at[2][i]}));
  return found;
}

TEST(FormulaBatch, EqualsEvaluationPointByPoint) {
  Random random(test_seed());
  for (int i = 0; i < 5'000; ++i) {
    const auto [tape, root] = random_formula::formula(random, between(random, 1, 30));
    for (const Batch kind : {Batch::row, Batch::points})
      ASSERT_EQ(differences(random, tape, root, root, kind), 0) << i;
  }
}

/// The comparison sees a difference of one bit in some points.
TEST(FormulaBatch, AnotherFormulaIsFound) {
  Random random(test_seed());
  certet::Tape tape;
  const auto x = tape.variable(0), y = tape.variable(1), z = tape.variable(2);
  const auto left = tape.add(certet::Operation::add, tape.add(certet::Operation::add, x, y), z);
  const auto right = tape.add(certet::Operation::add, x, tape.add(certet::Operation::add, y, z));
  int found = 0;
  for (int i = 0; i < 100; ++i) found += differences(random, tape, left, right, Batch::points);
  EXPECT_GT(found, 0);
}

}  // namespace
