/// \file
/// Sharp edges of solids of which signs alone are known: where they leave their box, and where parts
/// of them meet.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/features.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"
#include "judge.hpp"
#include "seed.hpp"

namespace {

using certet::Bounds;
using certet::Mesh;
using certet::Point3;
using Function = std::function<double(Point3)>;

constexpr double pi = std::numbers::pi;

/// A solid within bounds, and its mesh before and after.
struct Kept {
  Function solid;  ///< cut off
  Mesh before, after;
  certet::Features features;
  certet::FeatureFigures figures;
};

Kept keep(const Function& function, const Bounds& bounds, double size, double angle = 40,
          int threads = 2) {
  const certet::BoundedFunction<Function> domain(function, bounds, size);
  certet::Context context;
  context.threads = threads;
  const auto make = [&] {
    return certet::mesh(domain, certet::Stuffing(domain, domain.lattice(), certet::Method::embedded, context),
                        context);
  };
  const auto cut_off = [=](Point3 p) { return std::max(function(p), certet::beyond(bounds, p)); };
  Kept kept{cut_off, make(), make(), {}, {}};
  kept.features = features_of(kept.before, domain, angle, context);
  kept.figures = keep_features(kept.after, domain, angle, context);
  return kept;
}

/// The part of the boundary whose three points are at one side of a box, to some steps.
struct Opening {
  double area = 0;
  double off = 0;  ///< the farthest of the points, in steps
};
Opening opening(const Mesh& mesh, std::size_t axis, double plane) {
  certet::Context context;
  const double step = mesh.frame.size / (2 * certet::steps);
  Opening found;
  for (const auto& face : certet::survey(mesh, context).boundary) {
    std::array<Point3, 3> p;
    bool on = true;
    double off = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = mesh.frame.world(mesh.points[face.points[i]]);
      off = std::max(off, std::fabs(p[i][axis] - plane) / step);
      on = on && off < 1000;
    }
    if (!on) continue;
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    found.off = std::max(found.off, off);
    found.area += std::fabs((p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) -
                            (p[1][c] - p[0][c]) * (p[2][b] - p[0][b])) / 2;
  }
  return found;
}

double real(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

const Bounds unit_box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};

/// A point of the world in a solid's own axes, which are turned and shifted at random.
struct Placement {
  explicit Placement(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::array<double, 4> q;
    double square = 0;
    for (double& c : q) c = normal(random), square += c * c;
    for (double& c : q) c /= std::sqrt(square);
    const auto [w, x, y, z] = q;
    turn = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
    for (double& c : shift) c = real(random, -0.1, 0.1);
  }
  [[nodiscard]] Point3 own(const Point3& world) const {
    Point3 p{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) p[i] += turn[i][j] * (world[j] - shift[j]);
    return p;
  }
  std::array<std::array<double, 3>, 3> turn;
  Point3 shift{};
};

/// How far all of the edges that were found are from where a function is 0, in steps, and how long
/// they are, in the world.
struct Found {
  double farthest = 0, length = 0;
};
Found found_edges(const Kept& kept, const Function& distance) {
  const certet::Frame& frame = kept.before.frame;
  Found found;
  for (const certet::FeatureEdge& edge : kept.features.edges) {
    const Point3 a = frame.world(edge.from), b = frame.world(edge.to);
    found.farthest = std::max({found.farthest, std::fabs(distance(a)), std::fabs(distance(b))});
    found.length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  found.farthest /= frame.size / (2 * certet::steps);
  return found;
}

/// Where the solid leaves its box the mesh has its rim and its opening: what an opening lacks is
/// between the chords and the circle.
TEST(Rims, OpeningsOfDuctsAreKept) {
  for (int trial = 0; trial < 8; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), unsigned(trial)));
    // No nearer to the box's edges than two of the lattice's.
    const double radius = real(random, 0.2, 0.3), size = radius / real(random, 4, 8);
    const double x = real(random, -0.05, 0.05), y = real(random, -0.05, 0.05);
    const bool block = trial % 2 == 1;
    const Function solid = [=](Point3 p) {
      const double away = std::hypot(p[0] - x, p[1] - y) - radius;
      return block ? -away : away;
    };
    const Kept kept = keep(solid, unit_box, size);
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.solid), "") << trial;
    EXPECT_EQ(kept.figures.kept_corners, block ? 8U : 0U) << trial;
    EXPECT_EQ(kept.figures.corners, block ? 8U : 0U) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 99) << trial;
    EXPECT_NEAR(kept.figures.length * size, (block ? 12 : 0) + 4 * pi * radius, 0.01) << trial;
    const double circle = pi * radius * radius, truth = block ? 1 - circle : circle;
    for (const double plane : {-0.5, 0.5}) {
      const Opening before = opening(kept.before, 2, plane), after = opening(kept.after, 2, plane);
      EXPECT_NEAR(after.area / truth, 1, 0.35 * size * size / (radius * radius)) << trial;
      EXPECT_LT(std::fabs(after.area - truth), 0.25 * std::fabs(before.area - truth)) << trial;
      EXPECT_LE(after.off, 4) << trial;
    }
  }
}

/// All of its bounds are the solid.
TEST(Rims, ABoxThatIsFullHasItsEdges) {
  for (int trial = 0; trial < 4; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 100 + unsigned(trial)));
    const Bounds bounds{{real(random, -1, -0.5), real(random, -1, -0.5), real(random, -1, -0.5)},
                        {real(random, 0.5, 1), real(random, 0.5, 1), real(random, 0.5, 1)}};
    const Kept kept = keep([](Point3) { return -1.0; }, bounds, real(random, 0.1, 0.2));
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.solid), "") << trial;
    double length = 0, volume = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      length += 4 * (bounds.high[a] - bounds.low[a]);
      volume *= bounds.high[a] - bounds.low[a];
    }
    EXPECT_EQ(kept.figures.kept_corners, 8U) << trial;
    EXPECT_NEAR(kept.figures.length * kept.before.frame.size, length, 1e-3) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 97) << trial;
    EXPECT_NEAR(judge::volume(kept.after) / volume, 1, 1e-3) << trial;
  }
}

/// Six half spaces, of which three meet in each corner.
TEST(Rims, CornersOfHalfSpacesAreFound) {
  for (int trial = 0; trial < 8; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 200 + unsigned(trial)));
    const Placement placement(random);
    const Point3 half{real(random, 0.4, 0.7), real(random, 0.4, 0.7), real(random, 0.4, 0.7)};
    const Function solid = [=](Point3 world) {
      const Point3 p = placement.own(world);
      return std::max({std::fabs(p[0]) - half[0], std::fabs(p[1]) - half[1], std::fabs(p[2]) - half[2]});
    };
    const Kept kept = keep(solid, {{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}, real(random, 0.08, 0.16));
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.solid), "") << trial;
    ASSERT_EQ(kept.features.corners.size(), 8U) << trial;
    const double step = kept.before.frame.size / (2 * certet::steps);
    for (const certet::Coord3 corner : kept.features.corners) {
      const Point3 p = placement.own(kept.before.frame.world(corner));
      for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(std::fabs(p[a]), half[a], 12 * step) << trial;
    }
    const Found found = found_edges(kept, solid);
    EXPECT_LE(found.farthest, 12) << trial;
    EXPECT_NEAR(found.length, 8 * (half[0] + half[1] + half[2]), 1e-3) << trial;
    EXPECT_EQ(kept.figures.kept_corners, 8U) << trial;
    EXPECT_GE(kept.figures.followed_percent(), 96) << trial;
    EXPECT_NEAR(judge::volume(kept.after) / (8 * half[0] * half[1] * half[2]), 1, 2e-3) << trial;
  }
}

/// Two balls, of which one is added to the other, shared with it or taken away: where they meet is a
/// circle.
TEST(Rims, TheCirclesOfTwoBallsAreFound) {
  for (int trial = 0; trial < 9; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 300 + unsigned(trial)));
    const Placement placement(random);
    const double one = real(random, 0.6, 0.8), other = real(random, 0.5, 0.6), between = real(random, 0.55, 0.7);
    const auto first = [=](Point3 world) {
      const Point3 p = placement.own(world);
      return std::hypot(p[0], p[1], p[2]) - one;
    };
    const auto second = [=](Point3 world) {
      const Point3 p = placement.own(world);
      return std::hypot(p[0] - between, p[1], p[2]) - other;
    };
    const Function solid = [=](Point3 p) {
      switch (trial % 3) {
        case 0: return std::min(first(p), second(p));
        case 1: return std::max(first(p), second(p));
        default: return std::max(first(p), -second(p));
      }
    };
    const Kept kept = keep(solid, {{-1.6, -1.6, -1.6}, {1.6, 1.6, 1.6}}, real(random, 0.06, 0.1));
    EXPECT_EQ(judge::fault(kept.before, kept.after, kept.solid), "") << trial;
    EXPECT_TRUE(kept.features.corners.empty()) << trial;
    EXPECT_LE(found_edges(kept, first).farthest, 16) << trial;
    EXPECT_LE(found_edges(kept, second).farthest, 16) << trial;
    const double at = (one * one - other * other + between * between) / (2 * between);
    const double around = 2 * pi * std::sqrt(one * one - at * at);
    EXPECT_NEAR(found_edges(kept, first).length / around, 1, 1e-3) << trial;
    // What is left where one is taken away may be too sharp for a mesh of bounded angles.
    const double cosine = (one * one + other * other - between * between) / (2 * one * other);
    if (trial % 3 == 2 && cosine > 0.5) continue;
    EXPECT_GE(kept.figures.followed_percent(), 98) << trial;
  }
}

/// Nor have those that are bent within an edge of the lattice.
TEST(Rims, SmoothSolidsHaveNone) {
  const Bounds wide{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}};
  for (int trial = 0; trial < 6; ++trial) {
    std::mt19937_64 random(trial_seed(test_seed(), 400 + unsigned(trial)));
    const Placement placement(random);
    const double fillet = real(random, 0.05, 0.2), size = real(random, 0.1, 0.2);
    const Function solid = [=](Point3 world) {
      const Point3 p = placement.own(world);
      if (trial % 2 == 0) return std::hypot(std::hypot(p[0], p[1]) - 0.8, p[2]) - 0.3;
      double square = 0;
      for (const double c : p) square += std::pow(std::max(0.0, std::fabs(c) - 0.6), 2);
      return std::sqrt(square) - fillet;
    };
    const Kept kept = keep(solid, wide, size);
    EXPECT_TRUE(kept.features.none()) << trial;
    EXPECT_TRUE(std::ranges::equal(kept.before.points, kept.after.points)) << trial;
  }
}

TEST(Rims, ThePointsDoNotDependOnThreads) {
  const Function solid = [](Point3 p) {
    return std::max(std::hypot(p[0], p[1], p[2]) - 0.6, 0.2 - std::hypot(p[0], p[1]));
  };
  const Kept one = keep(solid, unit_box, 0.06, 40, 1);
  EXPECT_FALSE(one.features.none());
  for (const int threads : {2, 5}) {
    const Kept other = keep(solid, unit_box, 0.06, 40, threads);
    EXPECT_TRUE(std::ranges::equal(one.after.points, other.after.points));
    EXPECT_EQ(one.features.corners, other.features.corners);
  }
}

/// The judge notices a vertex beside the surface.
TEST(Rims, AVertexOffTheSurfaceIsNoticed) {
  Kept kept = keep([](Point3 p) { return std::hypot(p[0], p[1]) - 0.25; }, unit_box, 0.06);
  certet::Context context;
  int noticed = 0, tried = 0;
  for (const auto& face : certet::survey(kept.after, context).boundary) {
    certet::Coord3& point = kept.after.points[face.points[0]];
    const certet::Coord3 right = point;
    point = right + certet::Coord3{3000, 3000, 3000};
    noticed += !judge::fault(kept.before, kept.after, kept.solid).empty();
    point = right;
    if (++tried == 20) break;
  }
  EXPECT_GT(noticed, 15);
}

void tell(const char* name, double size, const Kept& kept) {
  const certet::FeatureFigures& f = kept.figures;
  std::printf("| %s | %.4g | %.2f %% | %.2f %% | %llu of %llu | %.4f |\n", name, size,
              f.followed_percent(), f.kept_percent(), static_cast<unsigned long long>(f.kept_corners),
              static_cast<unsigned long long>(f.corners), f.greatest_distance);
}

/// Those of cpp/docs/features.md.
TEST(Rims, Figures) {
  const Function duct = [](Point3 p) { return std::hypot(p[0], p[1]) - 0.25; };
  const Function hole = [=](Point3 p) { return -duct(p); };
  for (const double size : {1.0 / 16, 0.05, 1.0 / 32}) {
    for (const auto& [name, one] : {std::pair("duct", duct), std::pair("block with a duct", hole)}) {
      const Kept kept = keep(one, unit_box, size);
      tell(name, size, kept);
      const Opening before = opening(kept.before, 2, 0.5), after = opening(kept.after, 2, 0.5);
      const double truth = one(Point3{0, 0, 0}) < 0 ? pi / 16 : 1 - pi / 16;
      std::printf("  area %.4f %% -> %.4f %%, off %.1f -> %.1f steps\n", 100 * before.area / truth,
                  100 * after.area / truth, before.off, after.off);
    }
  }
  const Function two_balls = [](Point3 p) {
    return std::min(std::hypot(p[0] - 0.3, p[1], p[2]), std::hypot(p[0] + 0.3, p[1], p[2])) - 0.6;
  };
  const Function lens = [](Point3 p) {
    return std::max(std::hypot(p[0] - 0.3, p[1], p[2]), std::hypot(p[0] + 0.3, p[1], p[2])) - 0.6;
  };
  const Function bitten = [](Point3 p) {
    return std::max(std::hypot(p[0], p[1], p[2]) - 0.8, 0.5 - std::hypot(p[0] - 0.7, p[1], p[2]));
  };
  const Function cross = [](Point3 p) {
    return std::min({std::hypot(p[0], p[1]), std::hypot(p[1], p[2])}) - 0.4;
  };
  const Function cube = [](Point3 p) {
    const double x = 0.8 * p[0] + 0.6 * p[1], y = -0.6 * p[0] + 0.8 * p[1], z = 0.96 * p[2] + 0.28 * x,
                 w = -0.28 * p[2] + 0.96 * x;
    return std::max({std::fabs(w), std::fabs(y), std::fabs(z)}) - 0.6;
  };
  const Bounds wide{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};
  for (const auto& [name, one] :
       {std::pair("two balls", two_balls), std::pair("lens", lens), std::pair("bitten ball", bitten),
        std::pair("cross of cylinders", cross), std::pair("turned cube", cube)})
    for (const double size : {0.1, 0.06}) {
      const Kept kept = keep(one, wide, size);
      tell(name, size, kept);
    }
}

}  // namespace
