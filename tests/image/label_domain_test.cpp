// Solids of labels against their definition, point by point, and the meshes that are made of
// them.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "certet/stuffing.hpp"
#include "image_cases.hpp"

namespace certet {
namespace {

using namespace image_cases;

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
void expect_no_voxel_skipped(bool halfway) {
  for (const double size : {1.0, 0.1, 1.0 / 3, 0.9765625, 1e-5, 71234.5})
    for (const double more : {0.0, 1e-16, 4e-16, 1e-14, 1e-12, 1e-9, 1e-6, 0.001, 0.1, 0.25, 0.5, 1.7}) {
      const std::int64_t count = 5000;
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

TEST(LabelDomain, NoVoxelIsSkipped) {
  for (const bool halfway : {false, true}) expect_no_voxel_skipped(halfway);
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
/// with walls halfway, which violate nobody by key, as flat, and more is lost.
TEST(LabelDomain, AFlatWallIsMeshedFlat) {
  for (const auto& [halfway, method] : {std::pair(false, Method::key),
                                        std::pair(false, Method::embedded),
                                        std::pair(true, Method::embedded)}) {
    const auto cube = [](auto... at) { return std::min({at...}) > 0 && std::max({at...}) < 11; };
    const auto domain = label_domain(image_of(12, cube), {}, {.walls_halfway = halfway});
    Context context;
    const Mesh made = mesh(*domain, method, context);
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
    Context context;
    const double halfway =
        volume(mesh(*label_domain(image_of(24, ellipsoid)), Method::embedded, context));
    worst_halfway = std::max(worst_halfway, std::abs(halfway / voxels - 1));
  }
  EXPECT_GT(worst_halfway, 0.01);
}

}  // namespace
}  // namespace certet
