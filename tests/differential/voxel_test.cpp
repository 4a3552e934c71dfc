/// \file
/// The samples of label images.

#include <gtest/gtest.h>

#include <cmath>

#include "certet/image.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "samples.hpp"
#include "seed.hpp"

namespace {

using namespace certet;

/// A random image of labels 0 and 1, of 5 by 4 by 4 voxels.
struct RandomImage {
  std::uint64_t seed;
  Point3 spacing;

  [[nodiscard]] bool holds(Coord3 v) const {
    const auto within = [](std::int32_t c, std::int32_t n) { return 0 <= c && c < n; };
    return within(v.x, 5) && within(v.y, 4) && within(v.z, 4) &&
           mixed(seed, v.x, v.y, v.z) % 5 < 2;
  }

  [[nodiscard]] std::unique_ptr<PlacedDomain> domain(double size) const {
    Image image;
    image.name = "made here";
    image.size = {5, 4, 4};
    image.spacing = spacing;
    Buffer<std::uint8_t> voxels(80);
    for (std::int32_t n = 0; n < 80; ++n)
      voxels[static_cast<std::size_t>(n)] = holds({n % 5, n / 5 % 4, n / 20}) ? 1 : 0;
    image.voxels = std::move(voxels);
    return label_domain(std::move(image), {}, {.size = size, .margin = 1, .walls_halfway = false});
  }
};

/// The same lattice and voxels in 16ths, of which all lengths are whole numbers.
certified::VoxelGrid grid_of(const PlacedDomain& domain, const Point3& spacing) {
  const auto whole = [](double x) { return static_cast<std::int32_t>(std::lround(16 * x)); };
  const Point3& o = domain.frame().origin;
  return {whole(domain.frame().size) / 2,
          {whole(spacing[0]), whole(spacing[1]), whole(spacing[2])},
          {whole(o[0] + spacing[0] / 2), whole(o[1] + spacing[1] / 2), whole(o[2] + spacing[2] / 2)}};
}

/// Every sample of an image.
void compare_image(const RandomImage& image, const MethodFacts& method, Differences& differences) {
  const auto domain = image.domain(1);
  const certified::VoxelGrid grid = grid_of(*domain, image.spacing);
  const auto holds = [&](Coord3 v) { return image.holds(v); };
  expect_samples_of(grid, holds, *domain, domain->lattice(), method, differences);
}

/// Where no lattice point lies between two voxels.
Differences compare_images(const MethodFacts& method) {
  Differences differences;
  for (const Point3 spacing : {Point3{1, 1, 1}, Point3{1, 1.25, 1.375}})
    for (int n = 0; n < 3; ++n)
      compare_image({mixed(test_seed(), n), spacing}, method, differences);
  return differences;
}

TEST(Voxels, TheSamplesOfImagesAreAlike) {
  const Differences differences = compare_images(facts(Method::embedded));
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GT(differences.compared(), 3000);
}

/// The paper's method samples odd points as they are.
TEST(Voxels, CatchesSamplesAsTheyAre) {
  EXPECT_FALSE(compare_images(facts(Method::angles)).empty());
}

}  // namespace
