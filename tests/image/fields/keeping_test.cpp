// Whether smooth interfaces keep every label and every piece of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certet/image.hpp"
#include "disjoint_sets.hpp"
#include "label_images.hpp"
#include "lattice_materials.hpp"
#include "seed.hpp"

namespace certet {
namespace {

using label_images::blobs;
using label_images::noise;
using label_images::thin_things;
using lattice_materials::Cuts;
using lattice_materials::domain_of;
using lattice_materials::LatticeMaterials;

using Voxels = Buffer<std::uint16_t>;

/// Pieces of voxels by faces.
DisjointSets pieces_by_faces(const Image& image) {
  const auto& voxels = std::get<Voxels>(image.voxels);
  DisjointSets pieces(voxels.size());
  const auto [nx, ny, nz] = image.size;
  std::size_t at = 0;
  for (std::int64_t k = 0; k < nz; ++k)
    for (std::int64_t j = 0; j < ny; ++j)
      for (std::int64_t i = 0; i < nx; ++i, ++at) {
        const auto join = [&](std::int64_t back) {
          const std::size_t other = at - static_cast<std::size_t>(back);
          if (voxels[other] == voxels[at]) pieces.join(at, other);
        };
        if (i > 0) join(1);
        if (j > 0) join(nx);
        if (k > 0) join(nx * ny);
      }
  return pieces;
}

/// The voxel that a position of an image with the identity for axes lies in.
std::size_t voxel_at(const Image& image, const Point3& p) {
  std::size_t at = 0;
  for (std::size_t a = 3; a-- > 0;)
    at = at * static_cast<std::size_t>(image.size[a]) +
         static_cast<std::size_t>(std::clamp<std::int64_t>(
             std::llround(p[a] / image.spacing[a] - 1e-9), 0, image.size[a] - 1));
  return at;
}

/// Whether a position is at the centre of a voxel.
bool is_centre(const Image& image, const Point3& p) {
  for (std::size_t a = 0; a < 3; ++a) {
    const double voxel = p[a] / image.spacing[a];
    if (std::abs(voxel - std::round(voxel)) > 1e-6) return false;
  }
  return true;
}

enum class Which { points_at_centres, all_points };

/// Pieces of voxels that have none of the lattice's points, or whose points are of several
/// pieces of the lattice.
struct Losses {
  int pieces = 0, lost = 0, cut = 0;

  Losses(const Image& image, const PlacedDomain& domain, Which which) {
    const LatticeMaterials materials(domain);
    DisjointSets on_lattice(materials.size());
    materials.for_each_edge([&](Coord3, std::size_t one, Coord3, std::size_t other) {
      if (materials[one] == materials[other]) on_lattice.join(one, other);
    });
    const auto& voxels = std::get<Voxels>(image.voxels);
    DisjointSets in_image = pieces_by_faces(image);
    std::map<std::size_t, std::set<std::size_t>> found;
    for (std::size_t v = 0; v < voxels.size(); ++v)
      if (voxels[v] != 0) found[in_image.root(v)];
    materials.for_each([&](Coord3 point, std::size_t number) {
      if (materials[number] == 0) return;
      const Point3 at = domain.frame().world(steps * point);
      if (which == Which::points_at_centres && !is_centre(image, at)) return;
      const std::size_t voxel = voxel_at(image, at);
      if (domain.labels()[static_cast<std::size_t>(materials[number]) - 1] == voxels[voxel])
        found[in_image.root(voxel)].insert(on_lattice.root(number));
    });
    pieces = static_cast<int>(found.size());
    for (const auto& [piece, parts] : found) {
      lost += static_cast<int>(parts.empty());
      cut += static_cast<int>(parts.size() > 1);
    }
  }
};

std::vector<Image> hard_images(std::uint64_t seed) {
  std::vector<Image> images;
  images.push_back(noise(seed, {22, 19, 17}, 2));
  images.push_back(noise(seed + 1, {18, 17, 16}, 11));
  images.push_back(blobs(seed + 2, {40, 33, 29}, 6));
  images.push_back(thin_things());
  return images;
}

struct SizeCase {
  double size;
  Which which;
  int islets;  ///< of noise, at most
};

/// On lattices whose points are not those of the voxels, of some 1,200 pieces of noise one or two
/// may have an islet beside them; on finer ones more, where only points at centres are looked at.
TEST(Keeping, NoPieceIsLostOrCut) {
  const std::vector<Image> images = hard_images(test_seed());
  constexpr std::size_t noisy = 2;  // the first ones
  for (const auto& [size, which, beside] :
       {SizeCase{1, Which::all_points, 0}, SizeCase{0.5, Which::points_at_centres, 0},
        SizeCase{1.0 / 3, Which::points_at_centres, 0}, SizeCase{0.9, Which::all_points, 4},
        SizeCase{0.73, Which::all_points, 4}})
    for (std::size_t n = 0; n < images.size(); ++n) {
      const Losses losses(images[n], *domain_of(label_images::copy(images[n]), size), which);
      EXPECT_GT(losses.pieces, 10);
      EXPECT_EQ(losses.lost, 0) << size;
      EXPECT_LE(losses.cut, n < noisy ? beside : 0) << size;
    }
}

TEST(Keeping, PiecesOfThickSlicesAreKept) {
  for (const double thickness : {2.0, 2.5, 3.0, 1.25})
    for (Image& image : hard_images(7)) {
      image.spacing = {1, 1, thickness};
      const Losses losses(image, *domain_of(label_images::copy(image)),
                          thickness == std::round(thickness) ? Which::points_at_centres
                                                             : Which::all_points);
      EXPECT_EQ(losses.lost, 0) << thickness;
      EXPECT_EQ(losses.cut, 0) << thickness;
    }
}

/// The least distance, in steps, of a cut from an end that is a voxel's centre.
std::int32_t least_room(const Image& image, const PlacedDomain& domain) {
  const Cuts cuts(domain);
  std::int32_t room = steps;
  for (std::size_t e = 0; e < cuts.edges.size(); ++e) {
    const auto is_voxel = [&](Coord3 point) {
      const Point3 p = domain.frame().world(steps * point);
      for (std::size_t a = 0; a < 3; ++a)
        if (p[a] < 0 || p[a] > static_cast<double>(image.size[a] - 1)) return false;
      return is_centre(image, p);
    };
    const PartedEdge& edge = cuts.edges[e];
    if (!is_voxel(edge.first) || !is_voxel(edge.last)) continue;
    room = std::min({room, std::int32_t{cuts.steps[e]}, steps - cuts.steps[e]});
  }
  return room;
}

TEST(Keeping, VoxelsAreHeldApartFromEveryCut) {
  for (const Image& image : hard_images(11))
    EXPECT_GE(least_room(image, *domain_of(label_images::copy(image))), 16);
}

TEST(Keeping, AHoldThatIsForgottenIsCaught) {
  fields::Rules rules;
  rules.hold = false;
  for (const Image& image : hard_images(11))
    EXPECT_LT(least_room(image, *domain_of(label_images::copy(image), 1, rules)), 16);
}

TEST(Keeping, VoxelCentresHaveTheirLabel) {
  for (const Image& image : hard_images(13)) {
    const auto domain = domain_of(label_images::copy(image));
    const auto& voxels = std::get<Voxels>(image.voxels);
    const LatticeMaterials materials(*domain);
    std::size_t seen = 0;
    materials.for_each([&](Coord3 point, std::size_t number) {
      const Point3 p = domain->frame().world(steps * point);
      for (std::size_t a = 0; a < 3; ++a)
        if (p[a] < 0 || p[a] > static_cast<double>(image.size[a] - 1)) return;
      if ((point.x & 1) != 0) return;
      ++seen;
      const Material material = materials[number];
      ASSERT_EQ(material == 0 ? 0 : domain->labels()[static_cast<std::size_t>(material) - 1],
                voxels[voxel_at(image, p)]);
    });
    EXPECT_EQ(seen, voxels.size());
  }
}

/// The atlas of the Debian package mricron-data.
TEST(Keeping, AnAtlasKeepsItsRegionsAndTheirVolumes) {
  const std::filesystem::path file = "/usr/share/mricron/templates/aal.nii.gz";
  if (!can_read_images() || !std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto atlas = std::make_shared<const Image>(read_image(file));
  const auto domain = interface_domain(atlas, {}, {});
  for (const RegionVolume& region : domain->volumes())
    if (region.voxels >= 1000) {
      EXPECT_NEAR(region.volume / static_cast<double>(region.voxels), 1, 0.01) << region.label;
    }
  auto regions = regions_of_labels(*atlas, {});
  EXPECT_EQ(regions.size(), 116U);
  count_pieces(*atlas, {}, *domain, regions);
  for (const ImageRegion& region : regions) {
    EXPECT_GT(region.points, 0U) << region.label;
    EXPECT_TRUE(region.keeps_pieces()) << region.label;
  }
}

}  // namespace
}  // namespace certet
