// How much of its voxels' volume a thin part keeps by itself, without the constant of its
// label, which has to do for all parts of it.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "certet/image.hpp"
#include "label_images.hpp"
#include "lattice_materials.hpp"

namespace certet {
namespace {

using lattice_materials::domain_of;

const Point3 middle{15.37, 15.21, 15.6};

using Part = std::function<bool(const Point3& from_middle)>;

/// Between two planes, in a ball.
Part sheet(const Point3& normal, double thickness) {
  return [=](const Point3& q) {
    const double height = (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) /
                          label_images::norm(normal);
    return label_images::norm(q) < 12 && height > -0.5 * thickness && height <= 0.5 * thickness;
  };
}

/// Of square section, along an axis.
Part wire(int width) {
  return [=](const Point3& q) {
    return std::abs(q[2]) < 12 && q[0] > -1 && q[0] < width - 1 && q[1] > -1 && q[1] < width - 1;
  };
}

/// Of round section.
Part rod(const Point3& direction, double radius) {
  return [=](const Point3& q) {
    const double along = (direction[0] * q[0] + direction[1] * q[1] + direction[2] * q[2]) /
                         label_images::norm(direction);
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - along * along;
    return std::abs(along) < 12 && square < radius * radius;
  };
}

/// By how much of its voxels' volume its own is off.
double change(const Part& part, bool hold_slender = true) {
  fields::Rules rules;
  rules.keep_volumes = false;
  rules.hold_slender = hold_slender;
  const auto domain = domain_of(label_images::image_of({32, 32, 32}, [&](int i, int j, int k) {
    return part(label_images::minus({double(i), double(j), double(k)}, middle)) ? 1 : 2;
  }), 1, rules);
  const RegionVolume region = domain->volumes().front();
  return region.volume / static_cast<double>(region.voxels) - 1;
}

struct Case {
  std::string name;
  Part part;
  double low, high;  ///< between which the change is to be
};

std::vector<Case> cases() {
  return {{"sheet 1 along the axes", sheet({0, 0, 1}, 1), -0.05, 0.05},
          {"sheet 2 along the axes", sheet({0, 0, 1}, 2), -0.05, 0.05},
          {"sheet 1 at (1 1 1)", sheet({1, 1, 1}, 1), -0.15, 0.15},
          {"sheet 1 at (1 2 10)", sheet({1, 2, 10}, 1), -0.15, 0.15},
          {"sheet 1 at (4 3 10)", sheet({4, 3, 10}, 1), -0.2, 0.2},
          {"sheet 2 at (0 1 1)", sheet({0, 1, 1}, 2), -0.15, 0.15},
          {"sheet 2 at (1 2 10)", sheet({1, 2, 10}, 2), -0.15, 0.15},
          {"wire of 1 by 1", wire(1), -0.35, 0.1},
          {"wire of 2 by 2", wire(2), -0.15, 0.1},
          {"rod of 0.8 at (0 1 1)", rod({0, 1, 1}, 0.8), -0.25, 0.15},
          {"rod of 0.8 at (4 3 10)", rod({4, 3, 10}, 0.8), -0.25, 0.15}};
}

TEST(ThinFidelity, ThinPartsKeepTheirVolumeByThemselves) {
  for (const Case& one : cases()) {
    const double found = change(one.part);
    EXPECT_GE(found, one.low) << one.name;
    EXPECT_LE(found, one.high) << one.name;
    RecordProperty(one.name, std::to_string(found));
  }
}

/// Held no more than other voxels they would lose much.
TEST(ThinFidelity, AHoldThatIsForgottenIsCaught) {
  for (const double thickness : {1.0, 2.0})
    EXPECT_LT(change(sheet({0, 0, 1}, thickness), false), -0.08) << thickness;
  for (const int width : {1, 2}) EXPECT_LT(change(wire(width), false), -0.6) << width;
}

}  // namespace
}  // namespace certet
