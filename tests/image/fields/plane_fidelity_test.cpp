// Whether planes in which two labels meet are flat, whatever their slope to the planes of
// voxels: also those that are stairs with long treads.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "certet/image.hpp"
#include "deviation.hpp"
#include "label_images.hpp"
#include "lattice_materials.hpp"
#include "seed.hpp"

namespace certet {
namespace {

using lattice_materials::Cuts;
using lattice_materials::domain_of;

/// In voxels, of the stairs along the plane's axes.  Of a plane that is parallel to an axis, as
/// they are there, those along the other one.
double longest_tread(double slope, double direction) {
  double longest = 0;
  for (const double part : {std::abs(std::cos(direction)), std::abs(std::sin(direction))})
    if (part > 1e-6) longest = std::max(longest, 1 / (slope * part));
  return longest;
}

/// A plane that rises by `slope` voxels per voxel, in an image that is `wide` across it.
class Plane {
 public:
  Plane(double slope, double direction, std::size_t axis, double offset) : axis_(axis) {
    normal_ = {slope * std::cos(direction), slope * std::sin(direction), 1};
    // A tread that the border cuts off is no part of a slope.
    margin_ = 4 + std::min(static_cast<int>(std::ceil(1.42 * longest_tread(slope, direction))), 32);
    std::swap(normal_[axis], normal_[2]);
    const int across = 2 * margin_ + 16;
    size_.fill(across);
    size_[axis] = static_cast<std::int64_t>(1.5 * slope * across) + 14;
    for (std::size_t a = 0; a < 3; ++a)
      offset_ += normal_[a] * (0.5 * static_cast<double>(size_[a]) - 0.5);
    offset_ += offset;
  }

  [[nodiscard]] double height(const Point3& p) const {
    return (normal_[0] * p[0] + normal_[1] * p[1] + normal_[2] * p[2] - offset_) /
           label_images::norm(normal_);
  }

  [[nodiscard]] double flatness(const fields::Rules& rules) const {
    const auto domain = domain_of(label_images::image_of(size_, [&](int i, int j, int k) {
      return height({double(i), double(j), double(k)}) < 0 ? 1 : 2;
    }), 1, rules);
    const Cuts cuts(*domain);
    std::vector<Point3> points;
    for (std::size_t e = 0; e < cuts.edges.size(); ++e)
      if (const Point3 p = domain->frame().world(cuts.position(e)); is_inside(p)) points.push_back(p);
    EXPECT_GT(points.size(), 300U);
    return Flatness(points, [&](const Point3& p) { return height(p); }).half_width;
  }

 private:
  [[nodiscard]] bool is_inside(const Point3& p) const {
    for (std::size_t a = 0; a < 3; ++a) {
      const double margin = a == axis_ ? 1 : margin_;  // there the image ends
      if (p[a] < margin || p[a] > static_cast<double>(size_[a] - 1) - margin) return false;
    }
    return true;
  }

  std::size_t axis_;
  int margin_;
  Point3 normal_{};
  double offset_ = 0;
  std::array<std::int64_t, 3> size_{};
};

const std::vector<double> slopes{0.05, 0.07, 0.1, 0.13, 0.17, 0.2, 0.23, 0.26, 0.3, 0.4, 0.6, 0.8, 1};

/// The image's border bends planes; a constant would move all of them for it.
fields::Rules without_constants() {
  fields::Rules rules;
  rules.keep_volumes = false;
  return rules;
}

/// One in which no tread is so long that it stays: longer than 32 voxels.
double drawn_direction(double slope, std::mt19937_64& random) {
  std::uniform_real_distribution<double> turn(0, 6.283185);
  double direction = turn(random);
  while (longest_tread(slope, direction) > 31) direction = turn(random);
  return direction;
}

/// Planes of all slopes, in directions that a seed draws.
void expect_flat(std::uint64_t seed, double bar) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const double slope : slopes)
    for (int n = 0; n < 5; ++n) {
      const double direction = n == 0 ? 0 : n == 1 ? 0.785398 : drawn_direction(slope, random);
      const double offset = unit(random);
      EXPECT_LE(Plane(slope, direction, static_cast<std::size_t>(n) % 3, offset)
                    .flatness(without_constants()), bar)
          << "slope " << slope << ", direction " << direction << ", offset " << offset;
    }
}

TEST(PlaneFidelity, PlanesAreFlat) { expect_flat(1, 0.2); }

TEST(PlaneFidelity, PlanesOfAnySeedAreFlat) { expect_flat(test_seed(), 0.2); }

/// Planes of voxels' centres, by their normals, whose treads no step along the axes shows.  Those
/// normal to an axis have treads that become slopes.
constexpr std::array<Point3, 3> planes_of_centres{{{1, 1, 0}, {1, 0, 1}, {1, 1, 1}}};

/// A direction on the sphere, and the flatness that is to be there.
class Direction {
 public:
  explicit Direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal(0, 1);
    for (double& n : normal_) n = normal(random);
    for (std::size_t a = 0; a < 3; ++a)
      if (std::abs(normal_[a]) > std::abs(normal_[axis_])) axis_ = a;
    std::swap(normal_[axis_], normal_[2]);
    for (double& n : normal_) n /= std::abs(normal_[2]) > 0 ? normal_[2] : 1;
  }

  [[nodiscard]] double slope() const { return std::hypot(normal_[0], normal_[1]); }
  [[nodiscard]] double turn() const { return std::atan2(normal_[1], normal_[0]); }
  [[nodiscard]] std::size_t axis() const { return axis_; }

  /// Whether it has treads along the axes that are so long that they stay.
  [[nodiscard]] bool stays() const {
    return std::min(shorter_tread(), 1e3) > 31;
  }
  /// Beside a plane of centres all that a window of five voxels sees is that plane, in the
  /// middle of each tread, wherever between its layers the surface is: none that depends on
  /// such a window alone is flatter than half a layer there, but for what it sees of the ends.
  [[nodiscard]] double bar() const {
    double most = 0.2;
    const Point3 n{std::abs(normal_[0]), std::abs(normal_[1]), std::abs(normal_[2])};
    for (const Point3& p : planes_of_centres)
      for (const Point3& centre : {p, Point3{p[1], p[0], p[2]}, Point3{p[1], p[2], p[0]}, Point3{p[2], p[1], p[0]}}) {
        const double cosine = (n[0] * centre[0] + n[1] * centre[1] + n[2] * centre[2]) /
                              (label_images::norm(n) * label_images::norm(centre));
        const double layer = 1 / label_images::norm(centre);
        const double away = std::acos(std::min(cosine, 1.0));
        if (away < layer / shortest_seen) most = std::max(most, 0.5 * layer);
      }
    return most;
  }

 private:
  /// In voxels: longer treads a window of five sees but the ends of.
  static constexpr double shortest_seen = 5;
  [[nodiscard]] double shorter_tread() const {
    return 1 / std::max({std::abs(normal_[0]), std::abs(normal_[1]), 1e-9});
  }

  Point3 normal_{};
  std::size_t axis_ = 0;
};

/// Of so many random directions and offsets those that are less flat than they should be.
int uneven(std::uint64_t seed, int count, const fields::Rules& rules) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  int found = 0;
  for (int n = 0; n < count; ++n) {
    const Direction direction(random);
    const double offset = unit(random);
    if (direction.stays()) continue;
    const double flatness =
        Plane(direction.slope(), direction.turn(), direction.axis(), offset).flatness(rules);
    if (flatness <= direction.bar()) continue;
    ++found;
    std::cout << "slope " << direction.slope() << ", direction " << direction.turn()
              << ", offset " << offset << ": " << flatness << '\n';
  }
  return found;
}

TEST(PlaneFidelity, PlanesInAnyDirectionAreFlat) {
  EXPECT_EQ(uneven(test_seed(), 200, without_constants()), 0);
}

/// By the narrowest taps there are.
TEST(PlaneFidelity, TooLittleSmoothingIsCaught) {
  fields::Rules rules = without_constants();
  rules.taps.fill(fields::thin_taps());
  EXPECT_GT(uneven(test_seed(), 40, rules), 0);
}

TEST(PlaneFidelity, TreadsThatStayAreCaught) {
  fields::Rules rules = without_constants();
  rules.slope_treads = false;
  for (const double slope : {0.05, 0.07, 0.1, 0.13})
    EXPECT_GT(Plane(slope, 0.4, 2, 0.3).flatness(rules), 0.25) << slope;
}

}  // namespace
}  // namespace certet
