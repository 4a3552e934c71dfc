/// \file
/// The samples of label images: every neighbourhood of an odd point, and whole images.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "certet/image.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "engine/cuts.hpp"
#include "engine/part_cubes.hpp"
#include "engine/sample.hpp"
#include "seed.hpp"

namespace {

using namespace certet;
using core::CubeCorners;

/// The production side, as a value.
using PartedCubes = std::function<std::uint64_t(const CubeCorners&)>;

/// Each of the 2^8 sets of corners, 64 at a time, with the centre inside and outside.
Differences compare_cubes(const PartedCubes& parted_cubes) {
  Differences differences;
  constexpr certified::VoxelGrid one_each{1, {1, 1, 1}, {0, 0, 0}};  // each point its own voxel
  for (std::uint32_t first = 0; first < 256; first += 64) {
    CubeCorners corners{};
    for (std::uint32_t set = first; set < first + 64; ++set)
      for (std::uint32_t n = 0; n < 8; ++n)
        corners[n] |= std::uint64_t{set >> n & 1} << (set - first);
    const std::uint64_t parted = parted_cubes(corners);
    for (std::uint32_t set = first; set < first + 64; ++set)
      for (const bool centre : {false, true}) {
        constexpr Coord3 odd{7, -3, 5};
        const auto holds = [&](Coord3 voxel) {
          const Coord3 d = voxel - odd;
          if (d == Coord3{0, 0, 0}) return centre;
          const auto upper = [](std::int32_t c) { return c > 0 ? 1U : 0U; };
          return (set >> (upper(d.x) | upper(d.y) << 1 | upper(d.z) << 2) & 1) != 0;
        };
        const bool plus = centre && (parted >> (set - first) & 1) == 0;
        differences.expect(certified::voxel_sign(one_each, holds, odd) ==
                               (plus ? Sign::plus : Sign::minus),
                           [&] { return "corners " + std::to_string(set); });
      }
  }
  return differences;
}

/// How many groups the corners of one cube are in.
int groups(std::uint32_t set) {
  int count = 0;
  while (set != 0) {
    std::uint32_t group = set & -set;
    for (std::uint32_t before = 0; before != group;) {
      before = group;
      for (std::uint32_t n = 0; n < 8; ++n)
        for (const std::uint32_t beside : {n ^ 1, n ^ 2, n ^ 4})
          if ((group >> n & 1) != 0) group |= set & 1U << beside;
    }
    set &= ~group;
    ++count;
  }
  return count;
}

/// Cubes with at least so many groups.
PartedCubes with_groups(int least) {
  return [=](const CubeCorners& corners) {
    std::uint64_t parted = 0;
    for (int b = 0; b < 64; ++b) {
      std::uint32_t set = 0;
      for (std::size_t n = 0; n < 8; ++n)
        set |= static_cast<std::uint32_t>(corners[n] >> b & 1) << n;
      if (groups(set) >= least) parted |= std::uint64_t{1} << b;
    }
    return parted;
  };
}

TEST(Voxels, EveryCubeIsPartedAlike) {
  const Differences differences = compare_cubes(core::parted_cubes);
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_EQ(differences.compared(), 512);
  EXPECT_TRUE(compare_cubes(with_groups(2)).empty());
}

TEST(Voxels, CatchesARuleThatIsForgotten) {
  EXPECT_FALSE(compare_cubes([](const CubeCorners&) { return std::uint64_t{0}; }).empty());
}

TEST(Voxels, CatchesOneGroupMoreOrLess) {
  EXPECT_FALSE(compare_cubes(with_groups(3)).empty());
  EXPECT_FALSE(compare_cubes(with_groups(1)).empty());
}

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
    return label_domain(std::move(image), {}, {.size = size, .margin = 1});
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
  const Lattice& lattice = domain->lattice();
  Context context;
  const auto planes = core::sample(*domain, lattice, core::whole(lattice), method, context);
  for (const core::Grid g : core::grids)
    for (int k = 0; k < lattice.cells[2]; ++k)
      for (int j = 0; j < lattice.cells[1]; ++j)
        for (int i = 0; i < lattice.cells[0]; ++i) {
          const Coord3 point = core::lattice_point(lattice, {g, {}}, i, j, k);
          const bool plus = (planes.plus(g, j, k)[i >> 6] >> (i & 63) & 1) != 0;
          differences.expect(
              certified::voxel_sign(grid, holds, point) == (plus ? Sign::plus : Sign::minus),
              [&] { return "seed " + std::to_string(test_seed()); });
        }
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
