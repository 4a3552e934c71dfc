/// Meshes as voxels: each centre in one tetrahedron and no other, exactly.

#include "certet/voxelise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "certet/certet.hpp"
#include "seed.hpp"

namespace certet {
namespace {

using Labels = Buffer<std::int32_t>;

Image grid(std::array<std::int64_t, 3> size, const Point3& spacing = {1, 1, 1},
           const Point3& origin = {0, 0, 0}) {
  Image image;
  image.name = "the grid";
  image.size = size;
  image.spacing = spacing;
  image.origin = origin;
  return image;
}

std::vector<std::int32_t> labels_of(const VoxelisedMesh& made) {
  const auto& labels = std::get<Labels>(made.image.voxels);
  return {labels.begin(), labels.end()};
}

std::vector<std::int32_t> voxels_of(const FileMesh& mesh, const Image& place, int threads = 0) {
  Context context;
  context.threads = threads;
  return labels_of(voxelise(mesh, place_of(place), context));
}

VoxelisedMesh made_of(const FileMesh& mesh, const Image& place) {
  Context context;
  return voxelise(mesh, place_of(place), context);
}

/// A cube of n x n x n smaller ones, each of six tetrahedra around its diagonal, with corners at
/// whole numbers; each of the smaller ones is a region.
FileMesh cubes(int n) {
  FileMesh mesh;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.points.push_back({double(i), double(j), double(k)});
  const std::uint64_t steps[3] = {1, std::uint64_t(n) + 1, std::uint64_t(n + 1) * std::uint64_t(n + 1)};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const std::uint64_t corner = std::uint64_t(i) + std::uint64_t(j) * steps[1] + std::uint64_t(k) * steps[2];
        std::array<std::size_t, 3> way{0, 1, 2};
        do {
          const std::uint64_t a = corner + steps[way[0]], b = a + steps[way[1]], c = b + steps[way[2]];
          const bool even = (way[1] + 3 - way[0]) % 3 == 1;
          mesh.tets.push_back(even ? Tet<std::uint64_t>{corner, a, b, c} : Tet<std::uint64_t>{corner, b, a, c});
          mesh.labels.push_back(1 + i + n * (j + n * k));
        } while (std::next_permutation(way.begin(), way.end()));
      }
  return mesh;
}

/// Moves all points but those of the border, by less than what turns a tetrahedron over.
void shake(FileMesh& mesh, int n, std::mt19937& random) {
  std::uniform_real_distribution<double> by(-0.12, 0.12);
  for (Point3& point : mesh.points)
    if (std::ranges::all_of(point, [&](double x) { return x > 0 && x < n; }))
      for (double& x : point) x += by(random);
}

/// In how many tetrahedra a point is, and whether it is near to the face of one; in doubles.
std::pair<int, bool> plainly(const FileMesh& mesh, const Point3& at, std::int32_t& label) {
  int inside = 0;
  bool near = false;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    constexpr std::size_t none = 4;
    const auto volume = [&](std::size_t moved) {
      std::array<Point3, 4> p{};
      for (std::size_t c = 0; c < 4; ++c) p[c] = c == moved ? at : mesh.points[mesh.tets[t][c]];
      double m[3][3];
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t a = 0; a < 3; ++a) m[r][a] = p[r + 1][a] - p[0][a];
      return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 4; ++c) least = std::min(least, volume(c) / volume(none));
    near |= std::abs(least) < 1e-4;
    if (least <= 0) continue;
    ++inside;
    label = mesh.labels[t];
  }
  return {inside, near};
}

TEST(Voxelise, CentresAtCornersBelongToOneTetrahedron) {
  // Every centre is a point of the mesh; a step along the first axis, then the second and the
  // third leads into the small cube behind it.
  constexpr int n = 5;
  const VoxelisedMesh made = made_of(cubes(n), grid({n + 3, n + 3, n + 3}, {1, 1, 1}, {-1, -1, -1}));
  EXPECT_EQ(made.held, n * n * n);
  EXPECT_EQ(made.held_twice, 0);
  EXPECT_EQ(made.flat_tets, 0);
  const auto labels = labels_of(made);
  std::size_t at = 0;
  for (int k = -1; k <= n + 1; ++k)
    for (int j = -1; j <= n + 1; ++j)
      for (int i = -1; i <= n + 1; ++i) {
        const bool inside = std::min({i, j, k}) >= 0 && std::max({i, j, k}) < n;
        EXPECT_EQ(labels[at++], inside ? 1 + i + n * (j + n * k) : 0) << i << ' ' << j << ' ' << k;
      }
}

TEST(Voxelise, EveryCentreInAConformingMeshIsInOneTetrahedron) {
  std::mt19937 random(test_seed());
  constexpr int n = 4;
  for (int trial = 0; trial < 20; ++trial) {
    FileMesh mesh = cubes(n);
    shake(mesh, n, random);
    // Half of the centres lie in the planes of the border; of the others some are on faces.
    const VoxelisedMesh made = made_of(mesh, grid({17, 17, 17}, {0.25, 0.25, 0.25}));
    EXPECT_EQ(made.held, 16 * 16 * 16);
    EXPECT_EQ(made.held_twice, 0);
  }
}

TEST(Voxelise, AgreesWithPlainArithmetic) {
  std::mt19937 random(test_seed());
  constexpr int n = 3;
  FileMesh mesh = cubes(n);
  shake(mesh, n, random);
  const Image place = grid({9, 8, 7}, {0.41, 0.47, 0.53}, {-0.13, -0.21, -0.17});
  const auto labels = voxels_of(mesh, place);
  std::size_t at = 0, decided = 0;
  for (int k = 0; k < 7; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 9; ++i, ++at) {
        std::int32_t label = 0;
        const auto [inside, near] =
            plainly(mesh, {-0.13 + 0.41 * i, -0.21 + 0.47 * j, -0.17 + 0.53 * k}, label);
        if (near) continue;
        ++decided;
        EXPECT_LE(inside, 1);
        EXPECT_EQ(labels[at], label);
      }
  EXPECT_GT(decided, at * 9 / 10);
}

TEST(Voxelise, NeitherOrderNorTurnNorThreadsMatter) {
  std::mt19937 random(test_seed());
  FileMesh mesh = cubes(4);
  shake(mesh, 4, random);
  const Image place = grid({33, 33, 33}, {0.125, 0.125, 0.125});
  const auto labels = voxels_of(mesh, place, 1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(voxels_of(mesh, place, threads), labels);
  std::vector<std::size_t> order(mesh.tets.size());
  for (std::size_t t = 0; t < order.size(); ++t) order[t] = t;
  std::ranges::shuffle(order, random);
  FileMesh other = mesh;
  for (std::size_t t = 0; t < order.size(); ++t) {
    other.tets[t] = mesh.tets[order[t]];
    other.labels[t] = mesh.labels[order[t]];
    std::ranges::shuffle(other.tets[t], random);
  }
  EXPECT_EQ(voxels_of(other, place), labels);
}

TEST(Voxelise, DefectsShow) {
  const Image place = grid({17, 17, 17}, {0.25, 0.25, 0.25});
  const FileMesh whole = cubes(4);
  FileMesh lost = whole;
  lost.tets.pop_back();
  lost.labels.pop_back();
  EXPECT_LT(made_of(lost, place).held, 16 * 16 * 16);
  FileMesh twice = whole;
  twice.tets.push_back(twice.tets.front());
  twice.labels.push_back(7);
  const VoxelisedMesh made = made_of(twice, place);
  EXPECT_EQ(made.held, 16 * 16 * 16);
  EXPECT_GT(made.held_twice, 0);
  EXPECT_EQ(labels_of(made), voxels_of(whole, place)) << "the first tetrahedron has the centre";
  EXPECT_EQ(warnings_on_voxels(made).size(), 1);
  FileMesh flat = whole;
  flat.tets.push_back({0, 1, 2, 3});  // on one line
  flat.labels.push_back(7);
  EXPECT_EQ(made_of(flat, place).flat_tets, 1);
  EXPECT_EQ(made_of(flat, place).held, 16 * 16 * 16);
}

TEST(Voxelise, ABallIsABall) {
  const BoundedFunction ball([](Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },
                             {{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}, 0.1);
  const Mesh mesh = certet::mesh(ball);
  Image place = grid({40, 40, 40}, {0.06, 0.06, 0.06}, {1.17, -1.17, -1.17});
  place.axes = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // a quarter turn
  Context context;
  const VoxelisedMesh made = voxelise(mesh, place_of(place), context);
  const auto labels = labels_of(made);
  std::size_t at = 0;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i, ++at) {
        const double r = std::hypot(1.17 - 0.06 * j, -1.17 + 0.06 * i, -1.17 + 0.06 * k);
        if (std::abs(r - 1) < 0.02) continue;
        EXPECT_EQ(labels[at], r < 1 ? 1 : 0) << r;
      }
  EXPECT_EQ(made.held_twice, 0);
}

template <class Work>
void expect_refused(ErrorCode code, const std::string& words, const Work& work) {
  try {
    work();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Voxelise, RefusesWhatIsNoMeshOrNoGrid) {
  FileMesh mesh = cubes(1);
  const Image place = grid({4, 4, 4});
  expect_refused(ErrorCode::bad_input, "no voxels", [&] { made_of(mesh, grid({4, 0, 4})); });
  expect_refused(ErrorCode::too_large, "300000 voxels", [&] { made_of(mesh, grid({4, 300000, 1})); });
  expect_refused(ErrorCode::bad_option, "spacing", [&] { grid_around(mesh, {1, 0, 1}); });
  expect_refused(ErrorCode::too_large, "too small", [&] { grid_around(mesh, {1, 1e-9, 1}); });
  expect_refused(ErrorCode::bad_input, "no tetrahedra", [&] { grid_around({}, {1, 1, 1}); });
  mesh.points[0][1] = 1e9;
  expect_refused(ErrorCode::bad_input, "262,144", [&] { made_of(mesh, place); });
  mesh.points[0][1] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(ErrorCode::bad_input, "not finite", [&] { made_of(mesh, place); });
  mesh.points[0][1] = 0;
  mesh.tets[0][2] = 100;
  expect_refused(ErrorCode::bad_input, "not there", [&] { made_of(mesh, place); });
}

TEST(Voxelise, AGridAroundAMeshHoldsIt) {
  const Image place = grid_around(cubes(3), {0.5, 0.7, 10});
  EXPECT_EQ(place.size, (std::array<std::int64_t, 3>{6, 5, 1}));
  EXPECT_EQ(place.origin, (Point3{0.25, 0.35, 5}));
}

Image labelled(std::array<std::int64_t, 3> size, std::vector<std::int32_t> labels) {
  Image image = grid(size);
  Labels voxels(labels.size());
  std::ranges::copy(labels, voxels.begin());
  image.voxels = std::move(voxels);
  return image;
}

TEST(CompareLabels, Counts) {
  const auto overlaps = compare_labels(labelled({6, 1, 1}, {0, 1, 1, 2, 2, 0}),
                                       labelled({6, 1, 1}, {0, 1, 2, 2, 2, -7}));
  ASSERT_EQ(overlaps.size(), 3);
  EXPECT_EQ(overlaps[0].label, -7);
  EXPECT_EQ(overlaps[0].dice(), 0);
  EXPECT_EQ(overlaps[1].label, 1);
  EXPECT_DOUBLE_EQ(overlaps[1].dice(), 2.0 / 3);
  EXPECT_EQ(overlaps[2].label, 2);
  EXPECT_DOUBLE_EQ(overlaps[2].dice(), 4.0 / 5);
  EXPECT_EQ(overlaps[2].first, 2);
  EXPECT_EQ(overlaps[2].second, 3);
}

TEST(CompareLabels, RefusesOtherVoxels) {
  const Image image = labelled({2, 1, 1}, {1, 2});
  expect_refused(ErrorCode::bad_input, "differ in size",
                 [&] { compare_labels(image, labelled({1, 2, 1}, {1, 2})); });
  Image moved = labelled({2, 1, 1}, {1, 2});
  moved.origin[2] = 0.01;
  expect_refused(ErrorCode::bad_input, "same places", [&] { compare_labels(image, moved); });
  moved.origin[2] = 1e-5;
  EXPECT_EQ(compare_labels(image, moved).size(), 2);
  Image stretched = labelled({2, 1, 1}, {1, 2});
  stretched.spacing[0] = 1.01;
  expect_refused(ErrorCode::bad_input, "same places", [&] { compare_labels(image, stretched); });
  Image gray = grid({2, 1, 1});
  gray.voxels = Buffer<float>(2);
  expect_refused(ErrorCode::bad_input, "no labels", [&] { compare_labels(image, gray); });
}

TEST(WriteLabels, EveryFormatGivesTheLabelsBack) {
  if (!can_read_images()) GTEST_SKIP() << "reading images was not built in";
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("certet_labels_" + std::to_string(test_seed()));
  std::filesystem::create_directories(folder);
  for (const std::int32_t greatest : {200, 300, 70000})
    for (const char* const name : {"a.nrrd", "a.mha", "a.nii", "a.nii.gz"}) {
      Image image = labelled({4, 3, 2}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
                                         18, 19, 20, 21, 22, greatest});
      image.spacing = {1, 0.5, 2};
      image.origin = {-3, 4, 5.5};
      image.axes = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
      write_labels(image, folder / name);
      const Image again = read_image(folder / name);
      const auto overlaps = compare_labels(image, again);
      EXPECT_EQ(overlaps.size(), 23);
      for (const LabelOverlap& one : overlaps) EXPECT_EQ(one.dice(), 1);
    }
  expect_refused(ErrorCode::bad_option, ".nrrd", [&] { write_labels(grid({1, 1, 1}), folder / "a.png"); });
  expect_refused(ErrorCode::write_failed, "cannot be written",
                 [&] { write_labels(labelled({1, 1, 1}, {1}), folder / "none" / "a.nrrd"); });
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 4) << "nothing is left over";
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace certet
