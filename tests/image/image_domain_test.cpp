// Image domains against their definition, point by point: the sign of a lattice
// point is found again from its world coordinates and the voxels around it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "certet/stuffing.hpp"
#include "materials.hpp"
#include "seed.hpp"

namespace certet {
namespace {

constexpr unsigned seed = 20070;

using Axes = std::array<std::array<double, 3>, 3>;

const std::vector<Axes> all_axes{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},            // plain
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},           // left-handed
    {{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}},           // permuted, left-handed
    {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}}};  // turned

/// Blobs of value 0..3, some blocks of 8 uniform, most not.
template <class T>
Image blobs(const Axes& axes, const Point3& spacing) {
  Image image;
  image.name = "blobs";
  image.size = {19, 11, 26};
  image.spacing = spacing;
  image.origin = {5, -7, 11};
  image.axes = axes;
  Buffer<T> voxels(static_cast<std::size_t>(19 * 11 * 26));
  std::size_t at = 0;
  for (int k = 0; k < 26; ++k)
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 19; ++i)
        voxels[at++] = static_cast<T>(k < 8 ? 2 : k < 16 ? 0 : (i * i + 3 * j * k) / 17 % 4);
  image.voxels = std::move(voxels);
  return image;
}

template <class T>
double voxel(const Image& image, std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto& voxels = std::get<Buffer<T>>(image.voxels);
  return static_cast<double>(
      voxels[static_cast<std::size_t>((k * image.size[1] + j) * image.size[0] + i)]);
}

/// Voxel coordinates of a world point.
Point3 in_voxels(const Image& image, const Point3& world) {
  Point3 result;
  for (std::size_t a = 0; a < 3; ++a) {
    result[a] = 0;
    for (std::size_t r = 0; r < 3; ++r)
      result[a] += (world[r] - image.origin[r]) * image.axes[r][a] / image.spacing[a];
  }
  return result;
}

bool beyond(const Image& image, const Point3& at) {
  for (std::size_t a = 0; a < 3; ++a)
    if (at[a] < -0.5 || at[a] > static_cast<double>(image.size[a]) - 0.5) return true;
  return false;
}

/// Whether rounding may decide which voxel is nearest, or what is beyond.
bool ties(const Point3& at) {
  return std::any_of(at.begin(), at.end(), [](double c) {
    return std::abs(c - std::floor(c) - 0.5) < 1e-9;
  });
}

double trilinear(const Image& image, const Point3& at) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<std::int64_t, 3> n;
    for (std::size_t a = 0; a < 3; ++a) {
      const double last = static_cast<double>(image.size[a] - 1);
      const double c = std::clamp(at[a], 0.0, last);
      const double low = std::min(std::floor(c), last - 1);
      const bool high = (corner >> a) & 1;
      weight *= high ? c - low : 1 - (c - low);
      n[a] = static_cast<std::int64_t>(low) + (high ? 1 : 0);
    }
    sum += weight * voxel<float>(image, n[0], n[1], n[2]);
  }
  return sum;
}

/// Whether a point is among the outermost of its lattice, which the engine takes
/// for outside.
bool on_rim(const Lattice& lattice, Coord3 point) {
  const auto rim = [](std::int32_t cells, std::int32_t at) {
    return at < 2 || at >= 2 * cells - 2;
  };
  return rim(lattice.cells[0], point.x - lattice.origin.x) ||
         rim(lattice.cells[1], point.y - lattice.origin.y) ||
         rim(lattice.cells[2], point.z - lattice.origin.z);
}

/// Calls visit(lattice point, sign by row) for all points of a domain's lattice.
template <class Visit>
void for_all_points(const PlacedDomain& domain, const Visit& visit) {
  const Lattice& lattice = domain.lattice();
  std::vector<Sign> row(static_cast<std::size_t>(lattice.cells[0]));
  for (int odd = 0; odd < 2; ++odd)
    for (int k = 0; k < lattice.cells[2]; ++k)
      for (int j = 0; j < lattice.cells[1]; ++j) {
        const Coord3 first = lattice.origin + Coord3{odd, 2 * j + odd, 2 * k + odd};
        domain.row(first, row);
        for (int i = 0; i < lattice.cells[0]; ++i)
          visit(first + Coord3{2 * i, 0, 0}, row[static_cast<std::size_t>(i)]);
      }
}

Sign sign_at(const PlacedDomain& domain, Coord3 position) {
  Sign sign{};
  domain.at({&position, 1}, {&sign, 1});
  return sign;
}

struct Case {
  Axes axes;
  Point3 spacing;
  double size;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Axes& axes : all_axes)
    for (const double size : {1.0, 0.37, 0.5, 1.5, 2.0}) all.push_back({axes, {1, 1, 1}, size});
  for (const Axes& axes : all_axes) all.push_back({axes, {0.5, 1, 2}, 0.5});
  return all;
}

TEST(LabelDomain, RowsAreTheNearestVoxels) {
  for (const Case& c : cases()) {
    const Image image = blobs<std::int16_t>(c.axes, c.spacing);
    const auto domain =
        label_domain(blobs<std::int16_t>(c.axes, c.spacing), {{2, 3}}, {c.size, 1});
    for_all_points(*domain, [&](Coord3 point, Sign sign) {
      ASSERT_EQ(sign, sign_at(*domain, steps * point));
      ASSERT_FALSE(on_rim(domain->lattice(), point) && sign == Sign::plus);
      const Point3 at = in_voxels(image, domain->frame().world(steps * point));
      if (ties(at)) return;
      const bool inside = !beyond(image, at) &&
                          voxel<std::int16_t>(image, std::lround(at[0]), std::lround(at[1]),
                                              std::lround(at[2])) >= 2;
      ASSERT_EQ(sign, inside ? Sign::plus : Sign::minus);
    });
  }
}

TEST(LabelDomain, EveryVoxelHoldsOneEvenAndOneOddPoint) {
  for (const Axes& axes : all_axes) {
    const Image image = blobs<std::int16_t>(axes, {1, 1, 1});
    const auto domain = label_domain(blobs<std::int16_t>(axes, {1, 1, 1}), {{0, 3}}, {});
    std::multiset<std::array<long, 3>> even, odd;
    for_all_points(*domain, [&](Coord3 point, Sign sign) {
      const Point3 at = in_voxels(image, domain->frame().world(steps * point));
      ASSERT_EQ(sign == Sign::plus, !beyond(image, at));
      if (sign == Sign::plus)
        (point.x & 1 ? odd : even)
            .insert({std::lround(at[0]), std::lround(at[1]), std::lround(at[2])});
    });
    for (const auto* grid : {&even, &odd}) {
      EXPECT_EQ(grid->size(), 19U * 11U * 26U);
      EXPECT_EQ(std::set(grid->begin(), grid->end()).size(), grid->size());
    }
  }
}

/// The voxels of the lattice points along the first axis, even and odd ones by turns; 0
/// beyond the image.
std::vector<Material> voxels_along(std::int64_t count, double spacing, double size,
                                   bool walls_halfway) {
  Image image;
  image.name = "a row of voxels";
  image.size = {count, 1, 1};
  image.spacing = {spacing, 2 * spacing, 2 * spacing};
  Buffer<std::int32_t> voxels(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < voxels.size(); ++n) voxels[n] = static_cast<std::int32_t>(n) + 1;
  image.voxels = std::move(voxels);
  const auto domain = label_domain(std::move(image), {}, {.size = size, .walls_halfway = walls_halfway});
  EXPECT_TRUE(domain->even_points_tell_pieces());
  const Lattice& lattice = domain->lattice();
  std::vector<Material> line, row(static_cast<std::size_t>(lattice.cells[0]));
  for (std::int32_t y = 0; y < 2 * lattice.cells[1] && line.empty(); y += 2)
    for (std::int32_t z = 0; z < 2 * lattice.cells[2] && line.empty(); z += 2) {
      const Coord3 even = lattice.origin + Coord3{0, y, z};
      domain->row_materials(even, row);
      if (std::ranges::count(row, 0) == std::ssize(row)) continue;
      line.resize(2 * row.size());
      for (std::size_t i = 0; i < row.size(); ++i) line[2 * i] = row[i];
      domain->row_materials(even + Coord3{1, 1, 1}, row);
      if (std::ranges::count(row, 0) == std::ssize(row))
        domain->row_materials(even + Coord3{1, -1, -1}, row);
      for (std::size_t i = 0; i < row.size(); ++i) line[2 * i + 1] = row[i];
    }
  return line;
}

/// What the proof of VoxelPiecesKept needs of the voxels that lattice points lie in, along
/// each axis: they rise; no even point skips one, so that none is without; and a point has
/// a neighbour half an edge away in its own.  In floating point, for spacings that are the
/// size, or more than it by as little as can be.
TEST(LabelDomain, NoVoxelIsSkipped) {
  for (const double size : {1.0, 0.1, 1.0 / 3, 0.9765625, 1e-5, 71234.5})
    for (const double more : {0.0, 1e-16, 4e-16, 1e-14, 1e-12, 1e-9, 1e-6, 0.001, 0.1, 0.25, 0.5, 1.7}) {
      const std::int64_t count = 5000;
      const bool halfway = mixed(seed, std::lround(1e3 * more), std::lround(1e6 * size)) % 2 == 0;
      const auto line = voxels_along(count, size * (1 + more), size, halfway);
      const auto first = std::ranges::find(line, 1);
      const auto last = std::ranges::find(line.rbegin(), line.rend(), count).base();
      ASSERT_LT(first, last) << size << ' ' << more;
      std::set<Material> even;
      for (auto at = first; at != last; ++at) {
        if (at + 1 != last) {
          ASSERT_LE(at[0], at[1]) << size << ' ' << more;
        }
        ASSERT_TRUE((at != line.begin() && at[-1] == at[0]) || at[1] == at[0]) << size << ' ' << more;
        if ((at - line.begin()) % 2 == 0) even.insert(*at);
      }
      ASSERT_EQ(std::ssize(even), count) << size << ' ' << more;
    }
}

/// A cube of voxels of side 1, those inside with label 1.
template <class Inside>
Image image_of(std::int64_t side, const Inside& inside) {
  Image image;
  image.name = "made here";
  image.size = {side, side, side};
  Buffer<std::uint8_t> voxels(static_cast<std::size_t>(side * side * side));
  std::size_t at = 0;
  for (std::int64_t k = 0; k < side; ++k)
    for (std::int64_t j = 0; j < side; ++j)
      for (std::int64_t i = 0; i < side; ++i) voxels[at++] = inside(i, j, k) ? 1 : 0;
  image.voxels = std::move(voxels);
  return image;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  const auto points = world_points(mesh);
  for (const auto& [a, b, c, d] : std::get<0>(mesh.tets)) {
    const auto edge = [&](std::uint32_t to, std::size_t axis) { return points[to][axis] - points[a][axis]; };
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
      sum += edge(b, x) * (edge(c, y) * edge(d, z) - edge(c, z) * edge(d, y)) / 6;
    }
  }
  return sum;
}

/// Its walls are flat but for a cell at its edges, and its volume is its own but for these;
/// with walls halfway as flat, and more is lost.
TEST(LabelDomain, AFlatWallIsMeshedFlat) {
  for (const bool halfway : {false, true}) {
    const auto cube = [](auto... at) { return std::min({at...}) > 0 && std::max({at...}) < 11; };
    const auto domain = label_domain(image_of(12, cube), {}, {.walls_halfway = halfway});
    const Mesh made = mesh(*domain);
    EXPECT_GT(volume(made), halfway ? 977 : 998);
    EXPECT_LT(volume(made), 1000);
    std::size_t on_walls = 0;
    for (const Point3& p : world_points(made)) {
      std::array<double, 3> out;  // beyond the nearest wall
      for (std::size_t a = 0; a < 3; ++a) out[a] = std::max(0.5 - p[a], p[a] - 10.5);
      std::ranges::sort(out);
      EXPECT_LT(out[2], 1e-4);
      if (out[2] < -0.25 || out[1] > -1) continue;
      EXPECT_GT(out[2], -1e-4);
      ++on_walls;
    }
    EXPECT_GT(on_walls, 300U);
  }
}

/// Round and long regions, as large as the smaller ones of a brain, have the volume of their
/// voxels to 1 % at the voxel size; with walls halfway they do not.
TEST(LabelDomain, ARegionHasItsVolume) {
  std::mt19937 random(seed);
  double worst_halfway = 0;
  for (int n = 0; n < 10; ++n) {
    std::array<double, 3> centre, radius;
    for (std::size_t a = 0; a < 3; ++a) {
      centre[a] = std::uniform_real_distribution(11.0, 12.0)(random);
      radius[a] = std::uniform_real_distribution(3.0, 9.0)(random);
    }
    double voxels = 0;
    const auto ellipsoid = [&](auto... at) {
      const std::array<double, 3> place{static_cast<double>(at)...};
      double squared = 0;
      for (std::size_t a = 0; a < 3; ++a)
        squared += (place[a] - centre[a]) * (place[a] - centre[a]) / (radius[a] * radius[a]);
      voxels += squared < 1;
      return squared < 1;
    };
    const double made =
        volume(mesh(*label_domain(image_of(24, ellipsoid), {}, {.walls_halfway = false})));
    EXPECT_NEAR(made / voxels, 1, 0.01);
    voxels = 0;
    const double halfway = volume(mesh(*label_domain(image_of(24, ellipsoid))));
    worst_halfway = std::max(worst_halfway, std::abs(halfway / voxels - 1));
  }
  EXPECT_GT(worst_halfway, 0.01);
}

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
