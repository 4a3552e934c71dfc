// Image domains against their definition: signs of levels, bounds, frames, and what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "certet/error.hpp"
#include "image_cases.hpp"
#include "seed.hpp"

namespace certet {
namespace {

using namespace image_cases;

TEST(LevelDomain, RowsAreTrilinear) {
  for (const Case& c : cases()) {
    const Image image = blobs<float>(c.axes, c.spacing);
    const auto domain = level_domain(blobs<float>(c.axes, c.spacing), 1.3, {c.size, 1});
    for_all_points(*domain, [&](Coord3 point, Sign sign) {
      ASSERT_EQ(sign, sign_at(*domain, steps * point));
      ASSERT_FALSE(on_rim(domain->lattice(), point) && sign == Sign::plus);
      const Point3 at = in_voxels(image, domain->frame().world(steps * point));
      if (beyond(image, at)) {
        ASSERT_TRUE(sign == Sign::minus || ties(at));
        return;
      }
      const double value = trilinear(image, at);
      if (std::abs(value - 1.3) < 1e-9 || ties(at)) return;
      ASSERT_EQ(sign, value > 1.3 ? Sign::plus : Sign::minus);
    });
  }
}

TEST(LevelDomain, LatticeHoldsWhatReachesBeyondTheVoxelsAbove) {
  for (const Axes& axes : all_axes) {
    Image image = blobs<float>(axes, {1, 1, 1});
    auto& voxels = std::get<Buffer<float>>(image.voxels);
    std::fill(voxels.begin(), voxels.end(), 0.0F);
    voxels[(13 * 11 + 5) * 19 + 9] = 1;  // the solid is 0.99 voxels to each side of it
    const auto domain = level_domain(std::move(image), 0.01, {0.1, 1});
    std::size_t inside = 0;
    for_all_points(*domain, [&](Coord3 point, Sign sign) {
      ASSERT_FALSE(on_rim(domain->lattice(), point) && sign == Sign::plus);
      if (sign == Sign::plus) ++inside;
    });
    EXPECT_GT(inside, 0U);
  }
}

/// A bound over a box holds for every position in it, and uniform regions are
/// found: about a third of the blobs is uniform.
void expect_bounds(const PlacedDomain& domain) {
  std::mt19937 random(seed);
  const Lattice& lattice = domain.lattice();
  const auto between = [&](std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random);
  };
  int inside = 0, outside = 0;
  for (int n = 0; n < 3000; ++n) {
    Coord3 low, high;
    const auto choose = [&](std::int32_t origin, std::int32_t cells, std::int32_t& l,
                            std::int32_t& h) {
      l = origin + between(0, 2 * cells - 2);
      h = std::min(l + between(0, 9), origin + 2 * cells - 1);
    };
    choose(lattice.origin.x, lattice.cells[0], low.x, high.x);
    choose(lattice.origin.y, lattice.cells[1], low.y, high.y);
    choose(lattice.origin.z, lattice.cells[2], low.z, high.z);
    const Extent extent = domain.extent({low, high});
    if (extent == Extent::mixed) continue;
    (extent == Extent::inside ? inside : outside)++;
    for (int m = 0; m < 30; ++m) {
      const Coord3 position{between(steps * low.x, steps * high.x),
                            between(steps * low.y, steps * high.y),
                            between(steps * low.z, steps * high.z)};
      ASSERT_EQ(sign_at(domain, position),
                extent == Extent::inside ? Sign::plus : Sign::minus);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
}

TEST(ImageDomain, BoundsHold) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const Axes& axes : all_axes) {
    expect_bounds(*label_domain(blobs<std::int16_t>(axes, {1, 1, 1}), {}, {0.5, 2}));
    expect_bounds(*level_domain(blobs<float>(axes, {1, 1, 1}), 1.3, {0.5, 2}));
  }
}

TEST(ImageDomain, FramesAreRightHanded) {
  for (const Axes& axes : all_axes) {
    const auto domain = label_domain(blobs<std::int16_t>(axes, {1, 1, 1}), {}, {});
    const auto& m = domain->frame().axes;
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    EXPECT_NEAR(determinant, 1, 1e-12);
  }
}

ErrorCode code_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::cancelled;
}

TEST(ImageDomain, RefusesWhatMakesNoSense) {
  const auto labels = [](std::vector<LabelRange> ranges, ImageLattice lattice) {
    return code_of([&] {
      label_domain(blobs<std::int16_t>(all_axes[0], {1, 1, 1}), ranges, lattice);
    });
  };
  EXPECT_EQ(labels({{9, 12}}, {}), ErrorCode::empty_domain);
  EXPECT_EQ(labels({}, {-1, 2}), ErrorCode::bad_option);
  EXPECT_EQ(labels({}, {std::nan(""), 2}), ErrorCode::bad_option);
  EXPECT_EQ(labels({}, {1, 0}), ErrorCode::bad_option);
  EXPECT_EQ(labels({}, {1e-5, 2}), ErrorCode::too_large);
  EXPECT_EQ(code_of([] { label_domain(blobs<float>(all_axes[0], {1, 1, 1}), {}, {}); }),
            ErrorCode::bad_input);
  EXPECT_EQ(code_of([] { level_domain(blobs<float>(all_axes[0], {1, 1, 1}), 3, {}); }),
            ErrorCode::empty_domain);
  Image holed = blobs<float>(all_axes[0], {1, 1, 1});
  std::get<Buffer<float>>(holed.voxels)[77] = std::nanf("");
  EXPECT_EQ(code_of([&] { level_domain(std::move(holed), 1, {}); }), ErrorCode::bad_input);
  Image wild = blobs<double>(all_axes[0], {1, 1, 1});
  std::get<Buffer<double>>(wild.voxels)[77] = -1.1e300;
  EXPECT_EQ(code_of([&] { level_domain(std::move(wild), 1, {}); }), ErrorCode::bad_input);
}

}  // namespace
}  // namespace certet
