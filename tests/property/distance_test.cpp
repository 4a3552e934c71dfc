/// \file
/// How far a mesh is from a smooth surface: where violated vertices settle, and two moves
/// would pass each other, it is as near to it as by the published rule.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "topology.hpp"

namespace {

using namespace certet;
using settling::Rule;
using settling::Tets;

/// Of the middles of a surface's triangles and of their edges, in long edges.
struct Distances {
  double faces = 0, edges = 0;  ///< root mean squares
  double greatest = 0;
};

using Point = std::array<double, 3>;

Point middle(const Tets& mesh, std::initializer_list<std::uint32_t> corners) {
  Point sum{};
  for (const std::uint32_t n : corners) {
    const Coord3 p = mesh.points[n];
    const double share = 1 / (static_cast<double>(corners.size()) * steps);
    sum = {sum[0] + share * p.x, sum[1] + share * p.y, sum[2] + share * p.z};
  }
  return sum;
}

/// A torus of these radii in long edges, its middle so far from the origin along each axis.
struct Torus {
  double major, minor, middle;

  [[nodiscard]] double distance(const Point& p) const {
    const double tube = std::hypot(p[0] - middle, p[1] - middle) - 2 * major;
    return std::abs(std::hypot(tube, p[2] - middle) - 2 * minor) / 2;
  }
  [[nodiscard]] domains::Positional domain() const {
    return domains::of_level(domains::torus(middle, middle, middle, 2 * major, 2 * minor));
  }
  [[nodiscard]] Lattice lattice() const {
    const int wide = static_cast<int>(std::ceil(major + minor)) + 3;
    const int high = static_cast<int>(std::ceil(minor)) + 3;
    return {{-2 * wide, -2 * wide, -2 * high}, {2 * wide, 2 * wide, 2 * high}};
  }
};

Distances distances(const Torus& torus, const Tets& mesh) {
  Distances found;
  const std::vector<topology::Triangle> faces = topology::surface_of(mesh);
  const auto triangles = static_cast<double>(faces.size());
  const auto square = [&](const Point& p) {
    const double distance = torus.distance(p);
    found.greatest = std::max(found.greatest, distance);
    return distance * distance;
  };
  for (const auto& [a, b, c] : faces) {
    found.faces += square(middle(mesh, {a, b, c}));
    found.edges += square(middle(mesh, {a, b})) + square(middle(mesh, {b, c})) +
                   square(middle(mesh, {c, a}));
  }
  found.faces = std::sqrt(found.faces / triangles);
  found.edges = std::sqrt(found.edges / (3 * triangles));
  return found;
}

Distances by_engine(const Torus& torus, Method method) {
  Context context;
  return distances(torus, settling::tets_of(stuff(torus.domain(), torus.lattice(), {}, method, context)));
}

Distances by_model(const Torus& torus, const Rule& rule) {
  return distances(torus, settling::Model(torus.domain(), torus.lattice(), rule).mesh());
}

/// The torus of radii 1 and 0.4, at a size.
constexpr Torus of_size(double size, double middle) { return {1 / size, 0.4 / size, middle}; }

/// Root mean squares and the greatest, in multiples of those of the published rule.
struct Bars {
  double squares, greatest;
};

void expect_near(Method method, double size, const Bars& bars) {
  for (const double middle : {0.0, 0.5, 0.91}) {
    const Torus torus = of_size(size, middle);
    const Distances ours = by_engine(torus, method);
    const Distances theirs = by_engine(torus, Method::angles);
    std::printf("size %.2f middle %.2f: published %.5f %.5f %.4f, %s %.3f %.3f %.2f times it\n",
                size, middle, theirs.faces, theirs.edges, theirs.greatest, name(method).data(),
                ours.faces / theirs.faces, ours.edges / theirs.edges,
                ours.greatest / theirs.greatest);
    EXPECT_LT(ours.faces, bars.squares * theirs.faces) << size << ", " << middle;
    EXPECT_LT(ours.edges, bars.squares * theirs.edges) << size << ", " << middle;
    EXPECT_LT(ours.greatest, bars.greatest * theirs.greatest) << size << ", " << middle;
  }
}

TEST(Distance, OfATorusIsThatOfThePublishedRule) {
  for (const double size : {0.1, 0.07, 0.05, 0.04, 0.03})
    expect_near(Method::embedded, size, {1.05, 1.4});
}

/// What two neighbours give up is more of what a finer mesh misses.
TEST(Distance, OfAFineTorusIsNearlyThatOfThePublishedRule) {
  expect_near(Method::embedded, 0.02, {1.08, 1.8});
}

/// With lesser thresholds no move is shortened.
TEST(Distance, WhereDiagonalsFollowTheCutsIsThatOfThePublishedRule) {
  for (const double size : {0.1, 0.07, 0.05, 0.04, 0.03, 0.02})
    expect_near(Method::key, size, {1.05, 1.4});
}

/// Where the surface is level halfway between lattice planes, all is given up by one of two.
TEST(Distance, CatchesThatOneOfTwoGivesUpAll) {
  const Torus torus = of_size(0.05, 0.5);
  const Distances published = by_engine(torus, Method::angles);
  const Distances old = by_model(torus, {.share = false, .stay = false});
  EXPECT_GT(old.faces, 1.05 * published.faces);
  EXPECT_GT(old.edges, 1.05 * published.edges);
  EXPECT_GT(old.greatest, 1.4 * published.greatest);
}

}  // namespace
