// How far smooth interfaces are from the truth, where that is known; and by how much
// without the rules that are to bring them there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "certet/image.hpp"
#include "deviation.hpp"
#include "label_images.hpp"
#include "lattice_materials.hpp"

namespace certet {
namespace {

using label_images::Balls;
using label_images::image_of;
using lattice_materials::Cuts;
using lattice_materials::domain_of;

/// World positions of all cuts.
std::vector<Point3> cuts_of(const PlacedDomain& domain) {
  const Cuts cuts(domain);
  std::vector<Point3> points;
  for (std::size_t e = 0; e < cuts.edges.size(); ++e)
    points.push_back(domain.frame().world(cuts.position(e)));
  return points;
}

Deviation deviation(const Balls& balls, const PlacedDomain& domain) {
  return {cuts_of(domain), [&](const Point3& p) { return balls.distance(p); }};
}

/// The greatest error of a volume, by how much of its voxels'.
double volume_error(const InterfaceDomain& domain) {
  double greatest = 0;
  for (const RegionVolume& region : domain.volumes())
    greatest = std::max(greatest, std::abs(region.volume / static_cast<double>(region.voxels) - 1));
  return greatest;
}

class BallsOfWidth : public testing::TestWithParam<int> {};

TEST_P(BallsOfWidth, AreNearTheTruth) {
  const Balls balls(GetParam());
  const auto domain = domain_of(balls.image());
  const Deviation found = deviation(balls, *domain);
  EXPECT_LE(found.greatest, 0.6);
  EXPECT_LE(found.rms, 0.1);
  EXPECT_LE(volume_error(*domain), 0.005);
  RecordProperty("greatest", std::to_string(found.greatest));
  RecordProperty("rms", std::to_string(found.rms));
}
INSTANTIATE_TEST_SUITE_P(Fields, BallsOfWidth, testing::Values(64, 128));

TEST(Fidelity, FinerAndCoarserLatticesFindTheSameSurface) {
  const Balls balls(48);
  for (const double size : {0.5, 0.8, 1.0, 1.3}) {
    const auto domain = domain_of(balls.image(), size);
    const Deviation found = deviation(balls, *domain);
    EXPECT_LE(found.greatest, 0.75) << size;
    EXPECT_LE(found.rms, 0.12) << size;
  }
}

/// However the image is turned, and whatever its spacing, the world is the same.
TEST(Fidelity, AxesMayBeTurnedAndReflected) {
  Balls balls(48);
  const std::vector<std::array<std::array<double, 3>, 3>> all_axes{
      {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
      {{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}},
      {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}}};
  for (const auto& axes : all_axes) {
    Image image = balls.image();
    image.axes = axes;
    image.origin = {5, -7, 11};
    image.spacing = {0.5, 0.5, 0.5};
    const auto domain = domain_of(std::move(image), 0.5);
    std::vector<Point3> points = cuts_of(*domain);
    for (Point3& p : points) {
      Point3 voxel{};
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t r = 0; r < 3; ++r)
          voxel[a] += (p[r] - Point3{5, -7, 11}[r]) * axes[r][a] / 0.5;
      p = voxel;
    }
    const Deviation found(points, [&](const Point3& p) { return balls.distance(p); });
    EXPECT_LE(found.greatest, 0.6);
    EXPECT_LE(found.rms, 0.12);
  }
}

/// The distance from the plane in which two labels meet, in voxels.
Deviation from_plane(const Point3& normal, fields::Rules rules) {
  // The image's border bends the plane, for its voxels go on as they are; a constant
  // would move all of it to make up for that.
  rules.keep_volumes = false;
  const label_images::ObliquePlane plane{normal};
  std::vector<Point3> points = cuts_of(*domain_of(plane.image(), 1, rules));
  label_images::drop_near_border(points);
  return {points, [&](const Point3& p) { return plane.height(p); }};
}

TEST(Fidelity, ObliquePlanesAreFlat) {
  // By slope to the planes of voxels: no local filter sees terraces that are long.
  struct Bar {
    Point3 normal;
    double flat;
  };
  for (const auto& [normal, flat] :
       {Bar{{1, 2, 3}, 0.2}, Bar{{1, 1.07, 0.93}, 0.2}, Bar{{3, 4, 5}, 0.2}, Bar{{1, 0.3, 0.45}, 0.2},
        Bar{{0.3, 1, 0.1}, 0.2}, Bar{{0.22, 0, 1}, 0.22}, Bar{{0.19, 0.05, 1}, 0.22},
        Bar{{0.11, 0, 1}, 0.34}})
    EXPECT_LE(from_plane(normal, {}).greatest, flat)
        << normal[0] << ' ' << normal[1] << ' ' << normal[2];
}

TEST(Fidelity, WiderTapsAreFlatter) {
  fields::Rules wide;
  wide.taps.fill(fields::gaussian_taps(1.6));
  EXPECT_LE(from_plane({0.11, 0, 1}, wide).greatest, 0.23);
}

Image ball(double radius) {
  const int width = 2 * static_cast<int>(radius) + 9;
  const double middle = 0.5 * width - 0.3;
  return image_of({width, width, width}, [=](int i, int j, int k) {
    return std::hypot(i - middle, j - middle - 0.2, k - middle + 0.1) < radius ? 1 : 0;
  });
}

Image shell(double thickness) {
  return image_of({48, 48, 48}, [=](int i, int j, int k) {
    const double r = std::hypot(i - 23.4, j - 23.7, k - 24.1);
    return std::abs(r - 20) < 0.5 * thickness ? 1 : 0;
  });
}

TEST(Fidelity, SmallBallsKeepTheirVolume) {
  for (const double radius : {2.0, 2.5, 3.0, 4.0, 5.0, 6.2, 8.0})
    EXPECT_LE(volume_error(*domain_of(ball(radius))), 0.03) << radius;
}

TEST(Fidelity, ShellsKeepTheirVolume) {
  for (const double thickness : {1.0, 1.5, 2.0, 3.0})
    EXPECT_LE(volume_error(*domain_of(shell(thickness))), 0.05) << thickness;
}

TEST(Fidelity, NoRuleCanBeLeftOut) {
  fields::Rules no_constants, no_narrow;
  no_constants.keep_volumes = false;
  no_narrow.narrow_thin = false;
  EXPECT_GT(volume_error(*domain_of(ball(5), 1, no_constants)), 0.05);
  no_narrow.keep_volumes = false;
  EXPECT_GT(volume_error(*domain_of(shell(1), 1, no_narrow)), 0.1);
}

/// An image that is full is a box.
TEST(Fidelity, SolidsEndAtTheBorderOfTheImage) {
  for (const double size : {1.0, 0.7}) {
    const auto domain = domain_of(image_of({9, 7, 8}, [](int i, int, int) { return i < 4 ? 1 : 2; }),
                                  size);
    EXPECT_EQ(domain->volumes()[0].volume, 4 * 7 * 8);
    EXPECT_EQ(domain->volumes()[1].volume, 5 * 7 * 8);
    const Cuts cuts(*domain);
    int at_border = 0;
    for (std::size_t e = 0; e < cuts.edges.size(); ++e) {
      if (cuts.edges[e].of_last != 0) continue;
      ++at_border;
      EXPECT_TRUE(domain->border().front().is_at_face(cuts.position(e)));
    }
    EXPECT_GT(at_border, 100);
  }
}

}  // namespace
}  // namespace certet
