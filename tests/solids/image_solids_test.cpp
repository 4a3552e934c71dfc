/// \file
/// Images among several solids: against the image alone, and the voxels that it is made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "certet/bounded_function.hpp"
#include "certet/checksum.hpp"
#include "certet/combined_solids.hpp"
#include "certet/error.hpp"
#include "certet/image_solids.hpp"
#include "certet/placed_quality.hpp"
#include "certet/trimmed_domain.hpp"
#include "materials.hpp"
#include "seed.hpp"
#include "solids.hpp"

namespace certet {
namespace {

using solids::Measured;
using solids::measured;
using std::numbers::pi;

/// Labels 2 and 5 on the sides of a plane through a ball of radius 6 around the middle of 16
/// voxels, and gray values that fall off from there; along the axes given.
struct Scan {
  std::shared_ptr<const Image> labels, gray;
  Point3 centre{};

  explicit Scan(double angle, Point3 spacing = {1, 1, 1}) {
    Buffer<std::uint8_t> labelled(4096);
    Buffer<float> values(4096);
    for (std::size_t v = 0; v < 4096; ++v) {
      const Point3 at{double(v % 16) - 7.5, double(v / 16 % 16) - 7.5, double(v / 256) - 7.5};
      const double r = std::hypot(at[0], at[1], at[2]);
      labelled[v] = r > 6 ? 0 : at[0] + at[1] < 0.3 ? 2 : 5;
      values[v] = static_cast<float>(6 - r);
    }
    labels = image_of(angle, spacing, std::move(labelled));
    gray = image_of(angle, spacing, std::move(values));
    for (std::size_t r = 0; r < 3; ++r) {
      centre[r] = gray->origin[r];
      for (std::size_t a = 0; a < 3; ++a) centre[r] += gray->axes[r][a] * spacing[a] * 7.5;
    }
  }

 private:
  static std::shared_ptr<const Image> image_of(double angle, Point3 spacing, Voxels voxels) {
    Image image;
    image.name = "scan";
    image.size = {16, 16, 16};
    image.spacing = spacing;
    image.origin = {3, -4, 5};
    image.axes = {{{std::cos(angle), -std::sin(angle), 0},
                   {std::sin(angle), std::cos(angle), 0},
                   {0, 0, 1}}};
    image.voxels = std::move(voxels);
    return std::make_shared<const Image>(std::move(image));
  }
};

/// On the lattice of the image a solid is what the image alone is, to the bit.
TEST(ImageSolids, OnItsOwnLatticeItIsTheImage) {
  for (const double angle : {0., 0.4})
    for (const double size : {0., 0.5, 0.7}) {
      const Scan scan(angle, {1, 1, 1.25});
      const ImageLattice lattice{size, 3, false};
      const auto same = [&](const Solid& solid, const std::unique_ptr<PlacedDomain>& alone) {
        const Mesh one = mesh(*solid_domain(solid, size, 3)), other = mesh(*alone);
        EXPECT_EQ(checksum(one), checksum(other));
        EXPECT_TRUE(std::ranges::equal(one.labels, other.labels));
        EXPECT_GT(one.points.size(), 100u);
      };
      same(interface_solid(scan.labels, {}), interface_domain(scan.labels, {}, lattice));
      same(label_solid(scan.labels, {}), label_domain(scan.labels, {}, lattice));
      same(level_solid(scan.gray, 0.5), level_domain(scan.gray, 0.5, lattice));
    }
}

/// A label in a voxel, but near its faces, wherever the lattice lies.
TEST(ImageSolids, OnAnotherLatticeItHasTheSameVoxels) {
  std::mt19937_64 random(test_seed());
  const Scan scan(0.4);
  const auto& voxels = std::get<Buffer<std::uint8_t>>(scan.labels->voxels);
  const Solid solid = label_solid(scan.labels, {});
  const auto domain = placed_on(solid, lattice_around(solid.bounds, 0.8, 2));
  int seen = 0, beside = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto& cells = domain->lattice().cells;
    const auto at = [&](std::size_t a) { return between(random, -steps * cells[a], steps * cells[a]); };
    const Coord3 p{at(0), at(1), at(2)};
    const Point3 world = domain->frame().world(p);
    std::array<double, 3> voxel{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t r = 0; r < 3; ++r)
        voxel[a] += scan.labels->axes[r][a] * (world[r] - scan.labels->origin[r]);
    const auto label_at = [&](double shift) {
      std::int64_t index = 0;
      for (std::size_t a = 3; a-- > 0;) {
        const double v = std::floor(voxel[a] + 0.5 + shift);
        if (v < 0 || v > 15) return 0;
        index = 16 * index + static_cast<std::int64_t>(v);
      }
      return int{voxels[static_cast<std::size_t>(index)]};
    };
    const bool near_face = std::ranges::any_of(voxel, [](double v) {
      return std::fabs(v - std::floor(v) - 0.5) < 1e-4;
    });
    if (near_face) continue;
    Material material = 0;
    domain->materials_at({&p, 1}, {&material, 1});
    const int label = material == 0 ? 0 : domain->labels()[static_cast<std::size_t>(material - 1)];
    ASSERT_EQ(label, label_at(0));
    seen += label != 0;
    beside += label != label_at(0.1);
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(beside, 50);  // a tenth of a voxel beside would not go unnoticed
}

TEST(ImageSolids, RowsBlocksAndSignsAgree) {
  std::mt19937_64 random(test_seed());
  const Scan scan(0.4);
  int decided = 0;
  for (const Solid& solid : {interface_solid(scan.labels, {}), label_solid(scan.labels, {}),
                             level_solid(scan.gray, 0.5)})
    for (const PlacedLattice& around :
         {lattice_around(solid.bounds, 0.4, 2), solid.own(0.5, 2), solid.own(1, 4)})
      EXPECT_EQ(materials::first_contradiction(random, *placed_on(solid, around), around.lattice,
                                               200, decided), "");
  EXPECT_GT(decided, 3);
}

/// A ball of labels, and one of triangles whose centre is on its surface.
std::vector<NamedSolid> overlapping(const Scan& scan) {
  Point3 beside = scan.centre;
  beside[2] += 6;
  return {{"seg", interface_solid(scan.labels, {}), true},
          {"ball", solids::inside(surfaces::ball(beside, 4, 60, 30))}};
}

/// Of two balls the distance of whose centres is that of the surface of the first.
double lens(double first, double second) {
  const double d = first, r = second;
  return pi * (first + r - d) * (first + r - d) *
         (d * d + 2 * d * r - 3 * r * r + 2 * d * first + 6 * r * first - 3 * first * first) /
         (12 * d);
}

TEST(ImageSolids, LabelsAndASurfaceByPriority) {
  const double whole = 4 * pi / 3 * 216, ball = 4 * pi / 3 * 64, shared = lens(6, 4);
  for (const double angle : {0., 0.4}) {
    const Scan scan(angle);
    for (const bool image_first : {false, true}) {
      const auto domain = materials_domain(
          overlapping(scan), {}, image_first ? std::vector<std::string>{"seg"}
                                             : std::vector<std::string>{});
      EXPECT_EQ(domain->frame().size, 1);
      EXPECT_EQ(domain->names().at(6), "ball");
      const Measured found = measured(*domain);
      ASSERT_EQ(found.volumes.size(), 3u);
      const double labels = found.volumes.at(2) + found.volumes.at(5);
      EXPECT_NEAR(labels, whole - (image_first ? 0 : shared), 0.03 * whole);
      EXPECT_NEAR(found.volumes.at(6), ball - (image_first ? shared : 0), 0.05 * ball);
      EXPECT_EQ(standing_of(quality(found.mesh), bounds_of(found.mesh)), Standing::within);
    }
  }
}

TEST(ImageSolids, ChosenLabelsAreOneSolid) {
  const Scan scan(0);
  const Image one = chosen_as_one(*scan.labels, {{2, 4}});
  const auto& voxels = std::get<Buffer<std::uint8_t>>(one.voxels);
  EXPECT_EQ(std::ranges::count(voxels, 1),
            std::ranges::count(std::get<Buffer<std::uint8_t>>(scan.labels->voxels), 2));
  const auto domain = materials_domain(
      {{"ball", interface_solid(std::make_shared<const Image>(chosen_as_one(*scan.labels, {})), {})},
       {"core", shape_solid("sphere:1")}}, {});
  EXPECT_TRUE(std::ranges::equal(domain->labels(), std::vector<std::int32_t>{1, 2}));
  // Labels that are not to be kept are one solid as well.
  const auto united = materials_domain({{"ball", interface_solid(scan.labels, {})}}, {});
  EXPECT_TRUE(std::ranges::equal(united->labels(), std::vector<std::int32_t>{1}));
  EXPECT_EQ(measured(*united).volumes.size(), 1u);
}

TEST(ImageSolids, NumbersOfLabels) {
  const Scan scan(0);
  const Solid seg = label_solid(scan.labels, {});
  const auto labels = [](const std::vector<NamedSolid>& solids,
                         const std::vector<std::string>& priority) {
    const auto domain = materials_domain(solids, {}, priority);
    return std::vector<std::int32_t>(domain->labels().begin(), domain->labels().end());
  };
  const Solid ball = shape_solid("sphere:1");
  EXPECT_EQ(labels({{"a", ball}, {"seg", seg, true}, {"b", ball}}, {}),
            (std::vector<std::int32_t>{6, 2, 5, 7}));
  EXPECT_EQ(labels({{"a", ball}, {"seg", seg, true}, {"b", ball}}, {"a", "seg"}),
            (std::vector<std::int32_t>{7, 2, 5, 6}));
  try {
    static_cast<void>(materials_domain({{"seg", seg, true}, {"again", seg, true}}, {}));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "'seg' and 'again' both have label 2");
  }
}

/// What is left of labels: theirs, where the other solid is not; and cuts at its surface.
TEST(ImageSolids, TrimmedLabelsKeepTheirNumbers) {
  std::mt19937_64 random(test_seed());
  for (const double angle : {0., 0.4}) {
    const Scan scan(angle);
    const auto whole = std::shared_ptr<const PlacedDomain>(interface_domain(scan.labels, {}, {}));
    const Solid ball = solids::inside(surfaces::ball(scan.centre, 4, 60, 30));
    for (const bool inside : {false, true}) {
      const auto part = inside ? trimmed_domain(whole, {ball}, {}) : trimmed_domain(whole, {}, {ball});
      int decided = 0;
      EXPECT_EQ(materials::first_contradiction(random, *part, part->lattice(), 200, decided), "");
      const Measured found = measured(*part);
      const double hole = 4 * pi / 3 * 64, all = 4 * pi / 3 * 216;
      ASSERT_EQ(found.volumes.size(), 2u);
      EXPECT_NEAR(found.volumes.at(2) + found.volumes.at(5), inside ? hole : all - hole, 12);
      if (inside) EXPECT_LT(part->lattice().cells[0], whole->lattice().cells[0]);
      else EXPECT_EQ(part->lattice().cells, whole->lattice().cells);
      const auto b = placed_on(ball, {part->lattice(), part->frame()});
      for (int n = 0; n < 3000; ++n) {
        const Coord3 p{between(random, -8 * steps, 8 * steps), between(random, -8 * steps, 8 * steps),
                       between(random, -8 * steps, 8 * steps)};
        Material of_whole = 0, of_part = 0;
        Sign sign{};
        whole->materials_at({&p, 1}, {&of_whole, 1});
        part->materials_at({&p, 1}, {&of_part, 1});
        b->at({&p, 1}, {&sign, 1});
        ASSERT_EQ(of_part, (sign == Sign::plus) == inside ? of_whole : 0);
      }
    }
  }
}

TEST(ImageSolids, NothingInCommonIsRefused) {
  const Scan scan(0);
  const auto whole = std::shared_ptr<const PlacedDomain>(interface_domain(scan.labels, {}, {}));
  EXPECT_THROW(trimmed_domain(whole, {solids::block({90, 90, 90}, {95, 95, 95})}, {}), Error);
  const auto all = trimmed_domain(whole, {}, {solids::block({90, 90, 90}, {95, 95, 95})});
  EXPECT_EQ(mesh(*all).points.size(), mesh(*whole).points.size());
}

/// x and y change their signs, z does not.
TEST(ImageSolids, TurnedOver) {
  const Solid turned = turned_over(solids::block({1, 2, 3}, {2, 4, 6}));
  EXPECT_EQ(turned.bounds.low, (Point3{-2, -4, 3}));
  EXPECT_EQ(turned.bounds.high, (Point3{-1, -2, 6}));
  const auto domain = solid_domain(turned, 0.5);
  const Mesh found = mesh(*domain);
  for (const Coord3 point : found.points)
    EXPECT_LE(beyond(turned.bounds, domain->frame().world(point)), 1e-9);
  EXPECT_NEAR(quality(found).world.volume, 6, 0.3);
}

/// The same mesh for every number of threads.
TEST(ImageSolids, ThreadsDoNotMatter) {
  const Scan scan(0.4);
  const auto domain = materials_domain(overlapping(scan), {.size = 0.6});
  std::vector<std::uint64_t> sums;
  for (const int threads : {1, 2}) {
    Context context;
    context.threads = threads;
    sums.push_back(checksum(mesh(*domain, Method::embedded, context)));
  }
  EXPECT_EQ(sums[0], sums[1]);
}

}  // namespace
}  // namespace certet
