// How far the surfaces in a mesh, between regions and around all, are from the truth, and
// how much of its voxels' volume each region has.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "certet/image.hpp"
#include "certet/mesh.hpp"
#include "certet/stuffing.hpp"
#include "deviation.hpp"
#include "label_images.hpp"

namespace certet {
namespace {

using label_images::Balls;

/// A mesh's surfaces, and its volumes by label.
class Surfaces {
 public:
  explicit Surfaces(const PlacedDomain& domain) : mesh_(mesh(domain)), points_(world_points(mesh_)) {
    std::visit([&](const auto& tets) { gather(tets); }, mesh_.tets);
  }

  /// The corners and middles of all triangles in which two labels meet, or one and the outside.
  [[nodiscard]] std::vector<Point3> points() const {
    std::vector<Point3> found;
    for (const auto& [face, sides] : faces_) {
      if (sides.first == sides.second) continue;
      Point3 middle{};
      for (const std::size_t corner : face) {
        found.push_back(points_[corner]);
        for (std::size_t a = 0; a < 3; ++a) middle[a] += points_[corner][a] / 3;
      }
      found.push_back(middle);
    }
    return found;
  }
  [[nodiscard]] double volume(int label) const { return volumes_.at(label); }

 private:
  using Face = std::array<std::size_t, 3>;

  template <class Tets>
  void gather(const Tets& tets) {
    for (std::size_t t = 0; t < tets.size(); ++t) {
      const int label = mesh_.labels[t];
      volumes_[label] += volume_of(tets[t]);
      for (std::size_t out = 0; out < 4; ++out) {
        Face face{};
        for (std::size_t c = 0; c < 3; ++c) face[c] = tets[t][c < out ? c : c + 1];
        std::ranges::sort(face);
        const auto [at, is_new] = faces_.try_emplace(face, label, outside);
        if (!is_new) at->second.second = label;
      }
    }
  }

  template <class Tet>
  [[nodiscard]] double volume_of(const Tet& tet) const {
    std::array<Point3, 3> from_first;
    for (std::size_t c = 0; c < 3; ++c)
      from_first[c] = label_images::minus(points_[tet[c + 1]], points_[tet[0]]);
    const auto& [a, b, c] = from_first;
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }

  static constexpr int outside = -1;
  Mesh mesh_;
  Buffer<Point3> points_;
  std::map<Face, std::pair<int, int>> faces_;  ///< the labels of both sides
  std::map<int, double> volumes_;
};

class MeshedBalls : public testing::TestWithParam<int> {};

/// Nested, touching and overlapping: three labels and the outside meet in curves.
TEST_P(MeshedBalls, AreNearTheTruth) {
  const Balls balls(GetParam());
  const auto domain = interface_domain(balls.image());
  const Surfaces surfaces(*domain);
  const Deviation found(surfaces.points(), [&](const Point3& p) { return balls.distance(p); });
  EXPECT_LE(found.greatest, 0.6);
  EXPECT_LE(found.rms, 0.2);
  RecordProperty("greatest", std::to_string(found.greatest));
  RecordProperty("rms", std::to_string(found.rms));
  for (const RegionVolume& region : domain->volumes())
    EXPECT_NEAR(surfaces.volume(region.label) / static_cast<double>(region.voxels), 1, 0.01)
        << region.label;
}
INSTANTIATE_TEST_SUITE_P(Fields, MeshedBalls, testing::Values(64, 128));

/// The faces of voxels are farther from it: this is what smoothing is for.
TEST(MeshFidelity, VoxelFacesAreCaught) {
  const Balls balls(64);
  const Surfaces flat(*label_domain(balls.image(), {}, {.walls_halfway = false}));
  const Deviation found(flat.points(), [&](const Point3& p) { return balls.distance(p); });
  EXPECT_GT(found.greatest, 0.6);
  EXPECT_GT(found.rms, 0.2);
}

TEST(MeshFidelity, ObliquePlanesAreFlat) {
  for (const Point3& normal : {Point3{1, 2, 3}, Point3{1, 1.07, 0.93}, Point3{3, 4, 5},
                               Point3{1, 0.3, 0.45}, Point3{1, 0.4, 0}}) {
    const label_images::ObliquePlane plane{normal};
    std::vector<Point3> points = Surfaces(*interface_domain(plane.image())).points();
    label_images::drop_near_border(points);
    double low = 1e9, high = -1e9;
    for (const Point3& p : points) {
      low = std::min(low, plane.height(p));
      high = std::max(high, plane.height(p));
    }
    EXPECT_GT(points.size(), 1000U);
    EXPECT_LE(0.5 * (high - low), 0.2) << normal[0] << ' ' << normal[1] << ' ' << normal[2];
  }
}

/// How far off the volume of a sheet is that lies between two planes in a ball, one voxel apart.
double change_of_sheet(const Point3& normal, int inside, int outside) {
  const Point3 middle{23.37, 23.21, 23.6};
  const auto domain = interface_domain(label_images::image_of({48, 48, 48}, [&](int i, int j, int k) {
    const Point3 q = label_images::minus({double(i), double(j), double(k)}, middle);
    const double height = (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) /
                          label_images::norm(normal);
    return label_images::norm(q) < 20 && height > -0.5 && height <= 0.5 ? inside : outside;
  }));
  const RegionVolume region = domain->volumes()[static_cast<std::size_t>(inside - 1)];
  return Surfaces(*domain).volume(inside) / static_cast<double>(region.voxels) - 1;
}

/// A constant that lowers a label by a little must not put points of the lattice between
/// its voxels on the other side: such a sheet loses a sixth of its volume.
TEST(MeshFidelity, SheetsOneVoxelThickHaveNoHoles) {
  for (const Point3& normal : {Point3{0, 0, 1}, Point3{1, 2, 10}})
    for (const int inside : {1, 2})
      EXPECT_GT(change_of_sheet(normal, inside, 3 - inside), -0.05)
          << normal[0] << ' ' << normal[1] << ' ' << normal[2] << ", label " << inside;
}

}  // namespace
}  // namespace certet
