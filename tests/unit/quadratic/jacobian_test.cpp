// Bernstein coefficients against the determinant itself, and elements that are spoilt.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <vector>

#include "certet/curved_quality.hpp"
#include "mesh/quadratic/guard.hpp"
#include "mesh/quadratic/jacobian.hpp"
#include "seed.hpp"

namespace certet::quadratic {
namespace {

using Corners = std::array<Coord3, 4>;
using Bends = std::array<Coord3, 6>;
using Weights = std::array<double, 4>;

constexpr Corners corners{{{0, 0, 0}, {1000, 0, 0}, {0, 1200, 0}, {100, 300, 900}}};

/// The determinant at a place of an element, from the derivatives of the ten shape functions.
double determinant_at(const Corners& corners, const Bends& bends, const Weights& w) {
  std::array<std::array<double, 3>, 3> columns{};
  const auto add = [&](const std::array<double, 3>& x, const std::array<double, 4>& gradient) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t axis = 0; axis < 3; ++axis)
        columns[a][axis] += x[axis] * (gradient[a + 1] - gradient[0]);
  };
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<double, 4> gradient{};
    gradient[k] = 4 * w[k] - 1;
    add({double(corners[k].x), double(corners[k].y), double(corners[k].z)}, gradient);
  }
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [k, l] = tet_edges[e];
    const Coord3 p = corners[k], q = corners[l], b = bends[e];
    std::array<double, 4> gradient{};
    gradient[k] = 4 * w[l];
    gradient[l] = 4 * w[k];
    add({(p.x + q.x + b.x) / 2.0, (p.y + q.y + b.y) / 2.0, (p.z + q.z + b.z) / 2.0}, gradient);
  }
  return determinant(columns[0], columns[1], columns[2]);
}

/// The cubic with these Bernstein coefficients, times six, at a place.
double bernstein_at(const std::array<Wide, 20>& coefficients, const Weights& w) {
  double sum = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      for (std::size_t k = j; k < 4; ++k) {
        const double times = i == k ? 1 : i == j || j == k ? 3 : 6;
        sum += times * w[i] * w[j] * w[k] * static_cast<double>(coefficients[at++]);
      }
  return sum / 6;
}

template <class Visit>
void for_each_place(int n, const Visit& visit) {
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      for (int k = 0; i + j + k <= n; ++k)
        visit(Weights{double(i) / n, double(j) / n, double(k) / n, double(n - i - j - k) / n});
}

TEST(Jacobian, StraightElementsHaveAConstantOne) {
  for (const Wide coefficient : jacobian_coefficients(doubled_points(corners, Bends{})))
    EXPECT_EQ(static_cast<double>(coefficient), 6.0 * 1000 * 1200 * 900);
}

TEST(Jacobian, CoefficientsAreThoseOfTheDeterminant) {
  const std::uint64_t seed = test_seed();
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int32_t> bend(-300, 300);
  for (int round = 0; round < 200; ++round) {
    Bends bends;
    for (Coord3& b : bends) b = {bend(random), bend(random), bend(random)};
    const auto coefficients = jacobian_coefficients(doubled_points(corners, bends));
    const double least = static_cast<double>(*std::ranges::min_element(coefficients)) / 6;
    double lowest = INFINITY;
    for_each_place(8, [&](const Weights& w) {
      const double exact = determinant_at(corners, bends, w);
      lowest = std::min(lowest, exact);
      EXPECT_NEAR(bernstein_at(coefficients, w), exact, 1e-6 * 1e9);
    });
    EXPECT_LE(least, lowest + 1) << "a lower bound that is none";
    // A bend that is forgotten, or counted once instead of twice, is noticed.
    Bends other = bends;
    other[2].x += 40;
    const auto wrong = jacobian_coefficients(doubled_points(corners, other));
    EXPECT_NE(static_cast<double>(wrong[1]), static_cast<double>(coefficients[1]));
  }
}

TEST(Jacobian, CoefficientsDoNotOverflowAtTheEndsOfTheLattice) {
  constexpr std::int32_t far = 2'097'152'000;
  const Corners there{{{far, far, far}, {far - 262144, far, far}, {far, far - 262144, far},
                       {far, far, far - 262144}}};
  const auto coefficients = jacobian_coefficients(doubled_points(there, Bends{}));
  EXPECT_EQ(static_cast<double>(coefficients[0]), -6 * std::pow(262144.0, 3));
}

TEST(Guard, ASpoiltElementGetsItsGreatestBendBack) {
  SurfaceElement element{{10, 11, 12, 13, 14, 15}, corners};
  Context context;
  // The middle of edge 0-1 far within, so that the determinant at corner 0 turns over.
  std::vector<Bend> bends{{10, {-900, 0, 0}}, {14, {-20, 0, 0}}};
  const double least = take_back_spoiling(std::span(&element, 1), bends, context);
  ASSERT_EQ(bends.size(), 1u);
  EXPECT_EQ(bends[0].node, 14u);
  EXPECT_GE(least, 0.25);
  EXPECT_LT(least, 1);
}

TEST(Guard, WhatSpoilsNothingStays) {
  SurfaceElement element{{10, 11, 12, 13, 14, 15}, corners};
  Context context;
  std::vector<Bend> bends{{10, {-50, 60, 10}}, {14, {20, 0, 0}}};
  const std::vector<Bend> before = bends;
  take_back_spoiling(std::span(&element, 1), bends, context);
  EXPECT_EQ(bends, before);
}

/// Elements in the world.
class Measured : public testing::Test {
 protected:
  std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  std::vector<Tet<std::uint64_t>> tets{{0, 1, 2, 3}, {1, 4, 2, 3}};
  std::vector<Point3> middles;
  std::vector<std::array<std::uint64_t, 6>> numbers;

  void SetUp() override {
    const MiddleNodes nodes = middle_nodes(points.size(), tets);
    nodes.for_each(0, 5, [&](std::uint64_t, std::uint64_t a, std::uint64_t b) {
      middles.push_back({(points[a][0] + points[b][0]) / 2, (points[a][1] + points[b][1]) / 2,
                         (points[a][2] + points[b][2]) / 2});
    });
    for (const auto& tet : tets) numbers.push_back(nodes.of(tet));
  }
  CurvedQuality measure() {
    Context context;
    return measure_curved(points, tets, middles, numbers, context);
  }
};

TEST_F(Measured, StraightElementsAreSound) {
  const CurvedQuality found = measure();
  EXPECT_EQ(found.nodes, 9u);
  EXPECT_TRUE(found.failures.empty());
  EXPECT_EQ(found.bent, 0u);
  EXPECT_NEAR(found.least_jacobian, 1, 1e-12);
  EXPECT_NEAR(found.volume, 1.0 / 6 + 1.0 / 3, 1e-12);
}

TEST_F(Measured, PlantedDefectsAreFound) {
  const auto whole = middles;
  const auto sound = numbers;
  middles[numbers[0][0]] = {-0.5, 0, 0};
  EXPECT_EQ(measure().nonpositive, 1u);
  EXPECT_EQ(measure().bent, 1u);
  middles = whole;
  numbers[1][2] = numbers[1][0];
  EXPECT_EQ(measure().shared_nodes, 1u);
  EXPECT_EQ(measure().torn_edges, 1u);
  numbers = sound;
  numbers[0][3] = 77;
  EXPECT_EQ(measure().bad_indices, 1u);
  numbers = sound;
  middles[0][1] = NAN;
  EXPECT_EQ(measure().nonfinite, 1u);
  EXPECT_FALSE(measure().failures.empty());
}

}  // namespace
}  // namespace certet::quadratic
