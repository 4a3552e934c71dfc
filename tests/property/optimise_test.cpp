/// \file
/// What moving vertices must leave of a mesh: its angles no worse, its tetrahedra positive, its
/// topology and labels, its surfaces in their place; the same for every number of threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certet/bounded_function.hpp"
#include "certet/error.hpp"
#include "certet/optimise.hpp"
#include "certet/stuffing.hpp"
#include "certet/survey.hpp"
#include "domains.hpp"
#include "exact.hpp"
#include "materials.hpp"
#include "mesh_numbers.hpp"

namespace {

using certet::Coord3;
using certet::Mesh;
using certet::Method;

constexpr certet::Lattice lattice{{-4, -4, -4}, {14, 12, 13}};
constexpr double long_edge = 2.0 * certet::steps;

using Corners = std::vector<exact::Tet>;

Corners corners_of(const Mesh& mesh) {
  Corners all;
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets)
          all.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
      },
      mesh.tets);
  return all;
}

struct Extremes {
  long double least = 180, greatest = 0;
  bool positive = true;
};

Extremes extremes_of(const Corners& tets) {
  Extremes found;
  for (const exact::Tet& tet : tets) {
    found.positive = found.positive && exact::six_volume(tet) > 0;
    for (const exact::Dihedral& angle : exact::dihedrals(tet)) {
      found.least = std::min(found.least, angle.degrees());
      found.greatest = std::max(found.greatest, angle.degrees());
    }
  }
  return found;
}

/// Its points alone: the vertices of faces that one tetrahedron has, or two of different labels.
std::set<std::uint64_t> surface_points(const Mesh& mesh) {
  certet::Context context;
  const certet::Survey found = certet::survey(mesh, context);
  std::set<std::uint64_t> points;
  for (const auto& face : found.boundary) points.insert(face.points.begin(), face.points.end());
  for (const auto& interface : found.interfaces)
    for (const auto& face : interface.faces) points.insert(face.points.begin(), face.points.end());
  return points;
}

double distance(Coord3 a, Coord3 b) {
  return std::hypot(double{1} * (a.x - b.x), double{1} * (a.y - b.y), double{1} * (a.z - b.z)) /
         long_edge;
}

/// What is wrong with a mesh whose vertices moved, in words; empty if nothing is.
std::string fault(const Mesh& before, const Mesh& after) {
  if (numbers_of(before) != numbers_of(after)) return "tetrahedra have other points";
  if (!std::ranges::equal(before.labels, after.labels)) return "labels have changed";
  const Extremes old = extremes_of(corners_of(before)), now = extremes_of(corners_of(after));
  if (!now.positive) return "a tetrahedron is not positive";
  if (now.least < old.least) return "the least angle fell";
  if (now.greatest > old.greatest) return "the greatest angle grew";
  const std::set<std::uint64_t> surface = surface_points(before);
  for (std::uint64_t v = 0; v < before.points.size(); ++v) {
    const double most = surface.contains(v) ? certet::surface_reach : certet::interior_reach;
    if (distance(before.points[v], after.points[v]) > most + 1e-9)
      return "point " + std::to_string(v) + " went too far";
  }
  return "";
}

using Domain = std::shared_ptr<const certet::Domain>;

template <class D>
Domain shared(D domain) {
  return std::make_shared<const D>(std::move(domain));
}

/// The number-th of all kinds, at random.
Domain random_domain(std::uint64_t seed, int number) {
  std::mt19937_64 random(seed);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const std::vector<std::int32_t> cuts{1, 9000, 18000, 33000, 47000, 56000, 65535};
  switch (number % 8) {
    case 0: return shared(domains::of_level(domains::sphere(8, 7, 8, real(3, 9))));
    case 1: return shared(domains::of_level(domains::torus(9, 8, 8, real(4, 6), real(1.5, 3.5))));
    case 2: return shared(domains::of_level(domains::gyroid(real(8, 16), real(0.4, 0.9))));
    case 3: return shared(domains::noise(random(), 20));
    case 4: return shared(domains::random_cuts(random(), 10, cuts));
    case 5: return shared(materials::cubes(random(), 5, {3, 1, 8}, 60));
    case 6: return shared(materials::noise(random(), {1, 2}, 100));
    default: return shared(materials::random_cuts(random(), {1, 2, 5}, 100, cuts));
  }
}

Mesh mesh_of(const certet::Domain& domain, Method method) {
  certet::Context context;
  Mesh made = certet::stuff(domain, lattice, {}, method, context);
  made.border.assign(domain.border().begin(), domain.border().end());
  return made;
}

/// Whether anything is inside at the lattice's points: of thin things nothing may be.
bool has_mesh(const certet::Domain& domain, Method method) {
  certet::Context context;
  return certet::Stuffing(domain, lattice, method, context).tet_count() > 0;
}

certet::OptimiseFigures move(Mesh& mesh, const certet::Domain& domain, int threads,
                             double angle = 25) {
  certet::Context context;
  context.threads = threads;
  return certet::optimise(mesh, domain, {angle}, context);
}

constexpr Method methods[] = {Method::embedded, Method::angles, Method::embedding};

TEST(Optimise, NoAngleIsWorseAndAllElseStays) {
  long double least_gain = 0;
  int meshes = 0;
  for (int number = 0; number < 24; ++number) {
    const Domain domain = random_domain(trial_seed(test_seed(), 0) + unsigned(number), number);
    const Method method = methods[number / 8 % 3];
    if (!has_mesh(*domain, method)) continue;
    const Mesh before = mesh_of(*domain, method);
    for (const double angle : {15.0, 27.0}) {
      Mesh after = mesh_of(*domain, method);
      const certet::OptimiseFigures figures = move(after, *domain, 2, angle);
      ASSERT_EQ(fault(before, after), "") << "domain " << number << ", goal " << angle;
      ASSERT_LE(figures.short_after, figures.short_before);
      ++meshes;
      least_gain += extremes_of(corners_of(after)).least - extremes_of(corners_of(before)).least;
    }
  }
  std::cout << "the least angle grew by " << double(least_gain / meshes) << " degrees on the average\n";
  EXPECT_GT(meshes, 24);
  EXPECT_GT(least_gain / meshes, 0.5L);
}

TEST(Optimise, ThePointsDoNotDependOnThreads) {
  for (int number = 0; number < 8; ++number) {
    const Domain domain = random_domain(trial_seed(test_seed(), 1) + unsigned(number), number);
    if (!has_mesh(*domain, Method::embedded)) continue;
    Mesh one = mesh_of(*domain, Method::embedded);
    move(one, *domain, 1);
    for (const int threads : {2, 4}) {
      Mesh other = mesh_of(*domain, Method::embedded);
      move(other, *domain, threads);
      ASSERT_TRUE(std::ranges::equal(one.points, other.points))
          << "domain " << number << ", " << threads << " threads";
    }
  }
}

/// Bisection ends a step away from the surface.
TEST(Optimise, AVertexOfASurfaceStaysOnIt) {
  std::mt19937_64 random(test_seed());
  std::uint64_t moved = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const double radius = std::uniform_real_distribution(4.0, 9.0)(random);
    const auto domain = domains::of_level(domains::sphere(8, 7, 8, radius));
    const Mesh before = mesh_of(domain, Method::embedded);
    Mesh after = mesh_of(domain, Method::embedded);
    const certet::OptimiseFigures figures = move(after, domain, 1, 30);
    moved += figures.moved_on_surface;
    EXPECT_EQ(figures.left_surface, 0U);
    const auto off = [&](Coord3 p) {
      const double unit = certet::steps;
      return std::fabs(std::hypot(p.x - 8 * unit, p.y - 7 * unit, p.z - 8 * unit) - radius * unit);
    };
    for (const std::uint64_t v : surface_points(before)) {
      if (before.points[v] == after.points[v] || off(before.points[v]) > 4) continue;
      ASSERT_LE(off(after.points[v]), 2) << "point " << v << ", radius " << radius;
    }
  }
  EXPECT_GT(moved, 0U);
}

/// A ball cut off by a box: what is in a face of the box stays in it.
TEST(Optimise, AVertexOfAFaceOfTheBoxStaysInIt) {
  const certet::BoundedFunction domain(
      [](certet::Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
      {{-0.61, -0.83, -1.1}, {1.1, 0.72, 1.1}}, 0.1);
  const Mesh before = certet::mesh(domain);
  Mesh after = certet::mesh(domain);
  const certet::OptimiseFigures figures = move(after, domain, 2, 30);
  EXPECT_GT(figures.moved_on_surface, 0U);
  EXPECT_EQ(fault(before, after), "");
  certet::Context context;
  std::uint64_t moved = 0;
  for (const certet::BoundaryFace& face : certet::survey(before, context).boundary) {
    if (!face.is_cut_off) continue;
    for (const std::uint64_t v : face.points) {
      moved += before.points[v] != after.points[v];
      EXPECT_TRUE(domain.border()[0].is_at_face(after.points[v])) << v;
    }
  }
  EXPECT_GT(moved, 0U);
}

/// The worst that a vertex could do without a guard, which the test above must notice.
TEST(Optimise, AMoveWithoutAGuardIsNoticed) {
  const auto domain = domains::of_level(domains::torus(9, 8, 8, 5, 2.5));
  const Mesh before = mesh_of(domain, Method::embedded);
  Mesh after = mesh_of(domain, Method::embedded);
  move(after, domain, 1);
  ASSERT_EQ(fault(before, after), "");
  std::mt19937_64 random(test_seed());
  const std::vector<std::uint64_t> surface = [&] {
    const std::set<std::uint64_t> points = surface_points(before);
    return std::vector(points.begin(), points.end());
  }();
  int noticed = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const std::uint64_t v = surface[random() % surface.size()];
    const Coord3 right = after.points[v];
    const std::int32_t quarter = certet::steps / 2;
    after.points[v] = before.points[v] + Coord3{trial % 2 ? quarter : -quarter, 0, 0};
    noticed += !fault(before, after).empty();
    after.points[v] = right;
  }
  EXPECT_GT(noticed, 0);
  after.points[surface[0]] = before.points[surface[0]] + Coord3{0, 0, 3 * certet::steps / 4};
  EXPECT_NE(fault(before, after), "");
}

TEST(Optimise, WhatCannotBeIsRefused) {
  const auto domain = domains::of_level(domains::sphere(8, 7, 8, 5));
  Mesh mesh = mesh_of(domain, Method::embedded);
  for (const double angle : {0.0, -1.0, 61.0, std::nan("")})
    EXPECT_THROW(move(mesh, domain, 1, angle), certet::Error);
  Mesh steps = mesh_of(domain, Method::midpoint);
  EXPECT_THROW(move(steps, domain, 1), certet::Error);
}

}  // namespace
