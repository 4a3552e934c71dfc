/// \file
/// What moving vertices onto sharp edges and corners must reach, and what it must not break.

#include <gtest/gtest.h>

#include <iostream>

#include "certet/error.hpp"
#include "certet/features.hpp"
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
  Kept kept{mesh_of(domain, method), mesh_of(domain, method), features_of(domain.facets(), 40), {}};
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

TEST(Features, EdgesOfBoxesAreExact) {
  for (int trial = 0; trial < 16; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), unsigned(trial)));
    parts::Part part = parts::box(real(random, 1, 2), real(random, 1, 2), real(random, 1, 2));
    if (trial % 4 != 0) part = parts::placed(std::move(part), random);
    const Kept kept = keep(part, real(random, 0.08, 0.2));
    ASSERT_EQ(judge::fault(kept.before, kept.after, kept.features), "") << trial;
    const judge::Nearness found = judge::nearness(kept.after, kept.features);
    EXPECT_EQ(found.corners, 8U) << trial;
    EXPECT_LE(found.greatest, 2.0 / (2 * certet::steps)) << trial;  // two steps
    EXPECT_NEAR(judge::volume(kept.after) / part.volume, 1, 1e-4) << trial;
    EXPECT_TRUE(kept.figures.all_followed()) << trial;
    EXPECT_NEAR(kept.figures.kept_percent(), 100, 1e-9);
  }
}

}  // namespace
