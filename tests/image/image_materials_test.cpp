// Materials of image domains: those of the nearest voxels, and none that contradict the signs.

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

#include "certet/stuffing.hpp"
#include "image_cases.hpp"
#include "materials.hpp"

namespace certet {
namespace {

using namespace image_cases;

Material material_at(const PlacedDomain& domain, Coord3 position) {
  Material material{};
  domain.materials_at({&position, 1}, {&material, 1});
  return material;
}

/// Of labels that are far apart, beside each other, and negative.
const std::vector<std::vector<std::int32_t>> palettes{
    {0, 1, 2, 3}, {0, -5, 7, 2000000000}, {0, 100, 99, -70000}, {0, 4, 4, 4}};

Image painted(const Axes& axes, const std::vector<std::int32_t>& palette) {
  const Image plain = blobs<std::uint8_t>(axes, {1, 1, 1});
  Image image = blobs<std::int32_t>(axes, {1, 1, 1});
  const auto& from = std::get<Buffer<std::uint8_t>>(plain.voxels);
  auto& voxels = std::get<Buffer<std::int32_t>>(image.voxels);
  for (std::size_t v = 0; v < voxels.size(); ++v) voxels[v] = palette[from[v]];
  return image;
}

TEST(LabelDomain, MaterialsAreTheLabelsOfTheNearestVoxels) {
  for (const Axes& axes : all_axes)
    for (const auto& palette : palettes) {
      const Image image = painted(axes, palette);
      const auto domain = label_domain(painted(axes, palette), {}, {0.8, 1});
      std::set<std::int32_t> labels(palette.begin() + 1, palette.end());
      ASSERT_TRUE(std::ranges::equal(domain->labels(), labels));
      for_all_points(*domain, [&](Coord3 point, Sign) {
        const Point3 at = in_voxels(image, domain->frame().world(steps * point));
        if (ties(at)) return;
        const Material material = material_at(*domain, steps * point);
        const double there = beyond(image, at)
                                 ? 0
                                 : voxel<std::int32_t>(image, std::lround(at[0]),
                                                       std::lround(at[1]), std::lround(at[2]));
        ASSERT_EQ(material == 0 ? 0 : domain->labels()[static_cast<std::size_t>(material) - 1],
                  there);
      });
    }
}

/// Rows, points and blocks say the same, and agree with the signs.
void expect_agreement(const PlacedDomain& domain, int least_decided) {
  std::mt19937_64 random(seed);
  int decided = 0;
  EXPECT_EQ(materials::first_contradiction(random, domain, domain.lattice(), 200, decided), "");
  EXPECT_GT(decided, least_decided);
}

TEST(ImageDomain, MaterialsAgreeWithSigns) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const Axes& axes : all_axes) {
    expect_agreement(*label_domain(painted(axes, palettes[1]), {}, {0.5, 2}), 20);
    expect_agreement(*label_domain(painted(axes, palettes[0]), {{0, 2}}, {0.37, 2}), 20);
    expect_agreement(*level_domain(blobs<float>(axes, {1, 1, 1}), 1.3, {0.5, 2}), 20);
    auto whole = label_domain(painted(axes, palettes[2]), {}, {0.5, 2});
    const Point3 middle = whole->frame().world({0, 0, 0});
    Bounds box;
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = middle[a] - 5.3;
      box.high[a] = middle[a] + 4.1;
    }
    const std::vector<std::int32_t> labels(whole->labels().begin(), whole->labels().end());
    const auto cropped = cropped_domain(std::move(whole), box);
    expect_agreement(*cropped, 20);
    EXPECT_TRUE(std::ranges::equal(cropped->labels(), labels));
    EXPECT_EQ(cropped->border().size(), 2u);
  }
}

/// Smoothed labels, where smoothing is: a level of a blurred image by hand.
TEST(ImageDomain, MaterialsOfSmoothedLabelsAgreeWithSigns) {
  const auto labelled = std::make_shared<const Image>(painted(all_axes[0], palettes[1]));
  Image blurred = blobs<float>(all_axes[0], {1, 1, 1});
  for (float& value : std::get<Buffer<float>>(blurred.voxels)) value *= 0.3F;
  const auto domain = smoothed_domain(
      labelled, {}, std::make_shared<const Image>(std::move(blurred)), {0.7, 2});
  EXPECT_TRUE(std::ranges::equal(domain->labels(), std::vector<std::int32_t>{-5, 7, 2000000000}));
  expect_agreement(*domain, 5);
}

/// Many labels, which are sorted more than once on the way.
TEST(LabelDomain, ThereMayBeManyLabels) {
  Image image;
  image.name = "many";
  image.size = {70, 50, 40};
  Buffer<std::int32_t> voxels(70 * 50 * 40);
  for (std::size_t v = 0; v < voxels.size(); ++v)
    voxels[v] = 1 + static_cast<std::int32_t>(v * 7919 % 30011);
  image.voxels = std::move(voxels);
  const auto domain = label_domain(std::move(image), {}, {});
  ASSERT_EQ(domain->labels().size(), 30011u);
  EXPECT_TRUE(std::ranges::is_sorted(domain->labels()));
  expect_agreement(*domain, -1);  // of any box, no material is known
}

TEST(ImageDomain, LabelsAreChosenOnes) {
  for (const Axes& axes : all_axes)
    for (const Method method : {Method::angles, Method::midpoint}) {
      const auto domain =
          label_domain(blobs<std::int16_t>(axes, {1, 1, 1}), {{1, 1}, {3, 3}}, {});
      Context context;
      const Mesh mesh = stuff(*domain, domain->lattice(), domain->frame(), method, context);
      ASSERT_EQ(mesh.labels.size(), mesh.tet_count());
      for (const std::int32_t label : mesh.labels) ASSERT_TRUE(label == 1 || label == 3) << label;
    }
}

}  // namespace
}  // namespace certet
