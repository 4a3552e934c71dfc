/// \file
/// What moving vertices onto sharp edges and corners must reach, and what it must not break.

#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>

#include "certet/error.hpp"
#include "certet/features.hpp"
#include "certet/placed_quality.hpp"
#include "certet/shape.hpp"
#include "certet/stuffing.hpp"
#include "judge.hpp"
#include "parts.hpp"
#include "seed.hpp"

namespace {

using certet::Mesh;
using certet::Method;

/// A mesh before and after.
struct Kept {
  Mesh before, after;
  certet::Features features;
  certet::FeatureFigures figures;
};

Mesh mesh_of(const certet::PlacedDomain& domain, Method method) {
  certet::Context context;
  return certet::mesh(domain, certet::Stuffing(domain, domain.lattice(), method, context), context);
}

Kept keep(const certet::PlacedDomain& domain, int threads = 2, Method method = Method::embedded) {
  Kept kept{mesh_of(domain, method), mesh_of(domain, method), features_of(domain, 40), {}};
  certet::Context context;
  context.threads = threads;
  kept.figures = keep_features(kept.after, kept.features, context);
  return kept;
}

Kept keep(const parts::Part& part, double size, int threads = 2, Method method = Method::embedded) {
  return keep(*certet::surface_domain(part.surface, {size, 2}), threads, method);
}

double real(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

/// All of nearly all boxes; in one of some hundreds an edge is stopped beside a corner.
TEST(Features, EdgesOfBoxesAreExact) {
  int exact = 0;
  for (int trial = 0; trial < 16; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), unsigned(trial)));
    parts::Part part = parts::box(real(random, 1, 2), real(random, 1, 2), real(random, 1, 2));
    if (trial % 4 != 0) part = parts::placed(std::move(part), random);
    const Kept kept = keep(part, real(random, 0.08, 0.2));
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
    const judge::Nearness found = judge::nearness(kept.after, kept.features);
    EXPECT_EQ(found.corners, 8U) << trial;
    EXPECT_NEAR(judge::volume(kept.after) / part.volume, 1, 1e-3) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 97) << trial;
    EXPECT_EQ(kept.figures.all_followed(), certet::sentence_on(kept.figures).empty()) << trial;
    if (!kept.figures.all_followed()) continue;
    ++exact;
    EXPECT_LE(found.greatest, 2.0 / (2 * certet::steps)) << trial;  // two steps
    EXPECT_NEAR(judge::volume(kept.after) / part.volume, 1, 1e-4) << trial;
    EXPECT_NEAR(kept.figures.kept_percent(), 100, 1e-9);
  }
  EXPECT_GE(exact, 15);
}

/// A chord of a circle is beside it, and no nearer than the curvature of the side lets it.
TEST(Features, VerticesFollowTheCirclesOfCylinders) {
  constexpr int trials = 12;
  double kept_percent = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 100 + unsigned(trial)));
    constexpr int sides[] = {24, 48, 96, 200};
    parts::Part part = parts::cylinder(1, real(random, 1, 2), sides[trial % 4]);
    if (trial >= 4) part = parts::placed(std::move(part), random);
    const double size = real(random, 0.1, 0.25);
    const Kept kept = keep(part, size);
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
    EXPECT_NEAR(kept.figures.followed_percent(), 100, 1e-9) << trial;
    // The sagitta of a chord of some two edges, and what a side of the polygon leaves.
    const double chord = 2.2 * size;
    EXPECT_GE(kept.figures.kept_percent(), 60) << trial;
    kept_percent += kept.figures.kept_percent() / trials;
    EXPECT_LE(judge::nearness(kept.after, kept.features).greatest, chord * chord / 8 / size + 0.01) << trial;
    EXPECT_NEAR(judge::volume(kept.after) / part.volume, 1, 0.15 * size * size) << trial;
  }
  EXPECT_GE(kept_percent, 92);
}

/// Parts of re-entrant and of acute edges, and of edges that end in smooth ones.  In one of some
/// hundreds of parts an edge is stopped beside a corner.
TEST(Features, NearlyAllOfPartsIsKept) {
  double share = 0;
  int count = 0;
  for (int trial = 0; trial < 12; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 200 + unsigned(trial)));
    parts::Part part = trial % 3 == 0   ? parts::angle_beam(2.5, 1.2)
                       : trial % 3 == 1 ? parts::star(2, 1.1, 1)
                                        : parts::rounded_block(0.5, 2, 0.8, 24);
    part = parts::placed(std::move(part), random);
    const Kept kept = keep(part, real(random, 0.06, 0.12));
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
    const judge::Nearness found = judge::nearness(kept.after, kept.features);
    EXPECT_EQ(found.corners, kept.features.corners.size()) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 98) << trial;
    EXPECT_NEAR(judge::volume(kept.after) / part.volume, 1, 2e-3) << trial;
    share += kept.figures.followed_percent();
    ++count;
  }
  std::cout << share / count << " % of sharp edges are followed\n";
  EXPECT_GE(share / count, 99.7);
}

TEST(Features, CurvesMayEndWhereTheyBegin) {
  for (int trial = 0; trial < 4; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 250 + unsigned(trial)));
    parts::Part part = parts::drop(real(random, 0.8, 1.4), 60);
    if (trial > 0) part = parts::placed(std::move(part), random);
    const Kept kept = keep(part, real(random, 0.1, 0.16));
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
    EXPECT_EQ(kept.features.corners.size(), 2U) << trial;
    EXPECT_EQ(kept.figures.kept_corners, 2U) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 97) << trial;
  }
}

/// Parts that are too acute for their size, so that the guard stops many a move.
TEST(Features, TheBoundsHoldWhereEdgesAreAcute) {
  for (int trial = 0; trial < 12; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 300 + unsigned(trial)));
    const double height = real(random, 0.3, 0.8);
    parts::Part part = trial % 2 == 0 ? parts::star(2, real(random, 0.4, 0.7), 1)
                                      : parts::prism({{0, 0}, {2, 0}, {2, height}}, {1.5, height / 3}, 1);
    part = parts::placed(std::move(part), random);
    const Kept kept = keep(part, real(random, 0.12, 0.25));
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
  }
}

TEST(Features, ShapesAreKept) {
  for (const char* shape : {"box:1,1.3,0.8", "cylinder:1,1.3"}) {
    const certet::ShapeDomain domain(shape, {}, 0.13, 2);
    const Kept kept = keep(domain);
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << shape;
    EXPECT_TRUE(kept.figures.all_followed()) << shape;
  }
}

TEST(Features, EveryMethodKeepsItsBounds) {
  std::mt19937_64 random(test_seed());
  for (const Method method : {Method::embedded, Method::angles, Method::embedding, Method::key}) {
    const parts::Part part = parts::placed(parts::box(1, 1.4, 0.9), random);
    const Kept kept = keep(part, 0.12, 2, method);
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << certet::name(method);
    EXPECT_GE(kept.figures.followed_percent(), 95) << certet::name(method);
  }
  Mesh steps = mesh_of(*certet::surface_domain(parts::box(1, 1, 1).surface, {0.2, 2}), Method::midpoint);
  EXPECT_THROW(keep_features(steps, certet::Features{}), certet::Error);
}

TEST(Features, ThePointsDoNotDependOnThreads) {
  std::mt19937_64 random(test_seed());
  for (int trial = 0; trial < 4; ++trial) {
    const parts::Part part = parts::placed(parts::star(2, 1.1, 1), random);
    const Kept one = keep(part, 0.15, 1);
    for (const int threads : {2, 4})
      EXPECT_TRUE(std::ranges::equal(one.after.points, keep(part, 0.15, threads).after.points));
  }
}

/// The rows of cpp/docs/features.md.
TEST(Features, Figures) {
  struct Row {
    const char* name;
    parts::Part part;
    double size;
    bool turned;
  };
  const std::vector<Row> rows{
      {"box 1 x 1.3 x 0.8", parts::box(1, 1.3, 0.8), 0.1, false},
      {"box 1 x 1.3 x 0.8", parts::box(1, 1.3, 0.8), 0.1, true},
      {"cylinder, radius 1, 24 sides", parts::cylinder(1, 1.5, 24), 0.25, true},
      {"cylinder, radius 1, 200 sides", parts::cylinder(1, 1.5, 200), 0.25, true},
      {"cylinder, radius 1, 200 sides", parts::cylinder(1, 1.5, 200), 0.1, true},
      {"angle beam", parts::angle_beam(2.5, 1.2), 0.1, false},
      {"angle beam", parts::angle_beam(2.5, 1.2), 0.1, true},
      {"star", parts::star(2, 1.1, 1), 0.1, true},
      {"rounded block", parts::rounded_block(0.5, 2, 0.8, 24), 0.1, true},
      {"roof of 24 degrees", parts::prism({{0, 0}, {2, 0}, {2, 0.9}}, {1.5, 0.3}, 1.1), 0.1, false},
  };
  for (const Row& row : rows) {
    std::mt19937_64 random(7);
    const parts::Part part = row.turned ? parts::placed(row.part, random) : row.part;
    const Kept kept = keep(part, row.size);
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << row.name;
    const certet::Quality was = certet::quality(kept.before).lattice,
                          is = certet::quality(kept.after).lattice;
    const certet::FeatureFigures& told = kept.figures;
    std::printf("| %s%s | %g | %.2f %% | %.2f %% | %llu of %llu | %.4f | %.1f–%.1f° | %.1f–%.1f° | %+.3f %% | %+.3f %% |\n",
                row.name, row.turned ? ", turned" : "", row.size, told.followed_percent(),
                told.kept_percent(), static_cast<unsigned long long>(told.kept_corners),
                static_cast<unsigned long long>(told.corners), told.greatest_distance,
                was.min_dihedral, was.max_dihedral, is.min_dihedral, is.max_dihedral,
                100 * (judge::volume(kept.before) / part.volume - 1),
                100 * (judge::volume(kept.after) / part.volume - 1));
  }
}

/// What the judge must notice: a vertex that is off its curve, and one that was let through by no guard.
TEST(Features, WhatNoGuardWouldStopIsNoticed) {
  std::mt19937_64 random(test_seed());
  Kept kept = keep(parts::placed(parts::box(1, 1.3, 0.8), random), 0.13);
  ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "");
  ASSERT_LE(judge::nearness(kept.after, kept.features).greatest, 1e-4);
  int off = 0, folded = 0, blunt = 0, trials = 0;
  for (std::uint64_t v = 0; v < kept.after.points.size(); ++v) {
    const certet::Coord3 right = kept.after.points[v];
    if (right == kept.before.points[v]) continue;
    kept.after.points[v] = right + certet::Coord3{0, 5000, 0};
    off += !judge::fault(kept.before, kept.after, kept.features).empty();
    blunt += judge::nearness(kept.after, kept.features).greatest > 0.01;
    kept.after.points[v] = right + certet::Coord3{2 * certet::steps, 0, 0};
    folded += !judge::fault(kept.before, kept.after, kept.features).empty();
    kept.after.points[v] = right;
    if (++trials == 40) break;
  }
  EXPECT_EQ(trials, 40);
  EXPECT_GT(off, 10);     // some are inside
  EXPECT_GT(blunt, 5);    // some are beside
  EXPECT_GT(folded, 30);
}

}  // namespace
