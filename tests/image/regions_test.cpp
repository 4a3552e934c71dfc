// Pieces against a flood fill over voxels and over the lattice, neighbour by
// neighbour.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "certet/image.hpp"

namespace certet {
namespace {

constexpr unsigned seed = 41507;
using Place = std::array<int, 3>;
using Labels = std::map<Place, int>;  ///< of what is not 0
using Steps = std::vector<Place>;

Image noise(unsigned number, const std::array<std::int64_t, 3>& size, int labels) {
  std::mt19937 random(seed + number);
  Image image;
  image.name = "noise";
  image.size = size;
  Buffer<std::uint8_t> voxels(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (std::uint8_t& voxel : voxels) {
    const int drawn = static_cast<int>(random() % 5);
    voxel = static_cast<std::uint8_t>(drawn <= labels ? drawn : 0);
  }
  image.voxels = std::move(voxels);
  return image;
}

/// Steps to all voxels that share a face, or a face, an edge or a corner.
Steps around(bool corners) {
  Steps steps;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const int apart = x * x + y * y + z * z;
        if (apart == 1 || (corners && apart > 1)) steps.push_back({x, y, z});
      }
  return steps;
}

/// In lattice units: six long edges and eight short ones.
Steps lattice_edges() {
  Steps steps{{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}};
  for (int corner = 0; corner < 8; ++corner)
    steps.push_back({corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
  return steps;
}

std::map<int, std::uint64_t> flood(Labels labels, const Steps& steps) {
  std::map<int, std::uint64_t> pieces;
  while (!labels.empty()) {
    std::vector<Place> open{labels.begin()->first};
    const int label = labels.begin()->second;
    labels.erase(labels.begin());
    ++pieces[label];
    while (!open.empty()) {
      const Place at = open.back();
      open.pop_back();
      for (const Place& step : steps) {
        const auto next = labels.find({at[0] + step[0], at[1] + step[1], at[2] + step[2]});
        if (next == labels.end() || next->second != label) continue;
        open.push_back(next->first);
        labels.erase(next);
      }
    }
  }
  return pieces;
}

Labels of_voxels(const Image& image) {
  Labels labels;
  const auto& voxels = std::get<Buffer<std::uint8_t>>(image.voxels);
  std::size_t n = 0;
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i, ++n)
        if (voxels[n] != 0) labels[{i, j, k}] = voxels[n];
  return labels;
}

Labels of_points(const PlacedDomain& domain) {
  Labels labels;
  const Lattice& lattice = domain.lattice();
  for (int odd = 0; odd < 2; ++odd)
    for (int k = 0; k < lattice.cells[2]; ++k)
      for (int j = 0; j < lattice.cells[1]; ++j)
        for (int i = 0; i < lattice.cells[0]; ++i) {
          const Coord3 point = lattice.origin + Coord3{2 * i + odd, 2 * j + odd, 2 * k + odd};
          const Coord3 position = steps * point;
          Material material = 0;
          domain.materials_at({&position, 1}, {&material, 1});
          if (material == 0) continue;
          labels[{point.x, point.y, point.z}] =
              domain.labels()[static_cast<std::size_t>(material) - 1];
        }
  return labels;
}

struct Case {
  std::shared_ptr<const Image> image;
  std::unique_ptr<PlacedDomain> domain;
  decltype(regions_of_labels(std::declval<Image>(), {})) regions;
};

Case counted(unsigned number, const std::array<std::int64_t, 3>& size, int labels, double edge) {
  Case c{std::make_shared<const Image>(noise(number, size, labels)), nullptr, {}};
  c.domain = label_domain(c.image, {}, {edge, 1});
  c.regions = regions_of_labels(*c.image, {});
  count_pieces(*c.image, {}, *c.domain, c.regions);
  return c;
}

const std::vector<std::array<std::int64_t, 3>> sizes{{9, 8, 7}, {1, 9, 6}, {13, 1, 4}, {6, 7, 1}};

TEST(Regions, PiecesAreThoseOfAFloodFill) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  unsigned number = 0;
  for (const auto& size : sizes)
    for (const int labels : {1, 3})
      for (const double edge : {0.6, 1.0, 1.4, 2.3}) {
        const Case c = counted(++number, size, labels, edge);
        const Labels voxels = of_voxels(*c.image);
        auto faces = flood(voxels, around(false));
        auto corners = flood(voxels, around(true));
        auto lattice = flood(of_points(*c.domain), lattice_edges());
        for (const auto& region : c.regions) {
          ASSERT_EQ(region.pieces_by_faces, faces[region.label]);
          // Not counted where it makes no difference.
          if (region.pieces_by_corners != region.pieces_by_faces) {
            ASSERT_EQ(region.pieces_by_corners, corners[region.label]);
          }
          ASSERT_EQ(region.lattice_pieces, lattice[region.label]);
        }
      }
}

/// The flood fill tells the neighbourhoods apart, so that a wrong one is noticed.
TEST(Regions, NeighbourhoodsDiffer) {
  const Case c = counted(1, {25, 24, 23}, 1, 1.4);
  const Labels voxels = of_voxels(*c.image);
  EXPECT_NE(flood(voxels, around(false)), flood(voxels, around(true)));
  const Steps all = lattice_edges();
  for (std::size_t missing = 0; missing < all.size(); missing += 2) {
    // Both ways, or a neighbour would still be found from the other side.
    Steps fewer;
    for (const Place& step : all)
      if (step != all[missing] &&
          step != Place{-all[missing][0], -all[missing][1], -all[missing][2]})
        fewer.push_back(step);
    const Labels points = of_points(*c.domain);
    EXPECT_NE(flood(points, all), flood(points, fewer)) << missing;
  }
}

TEST(Regions, NothingIsLostAtTheSizeOfVoxels) {
  unsigned number = 100;
  for (const auto& size : sizes)
    for (const double edge : {1.0, 0.8, 0.5})
      for (const auto& region : counted(++number, size, 3, edge).regions)
        EXPECT_TRUE(region.keeps_pieces() && region.points > 0) << region.label;
}

/// With any lattice of the certain size a whole tetrahedron has the label: an even
/// point, the next one along an axis, and the two odd points between them.
TEST(Regions, TheCertainSizeHoldsATetrahedron) {
  for (int edge = 1; edge <= 4; ++edge)
    for (int shift = 0; shift < 5; ++shift) {
      Image image;
      image.size = {12, 12, 12};
      Buffer<std::uint8_t> voxels(12 * 12 * 12);
      for (int n = 0; n < 12 * 12 * 12; ++n) {
        const int at[3] = {n % 12, n / 12 % 12, n / 144};
        bool cube = true;
        for (const int place : at) cube = cube && place >= 2 + shift && place < 2 + shift + edge;
        voxels[static_cast<std::size_t>(n)] = cube ? 7 : 1;
      }
      image.voxels = std::move(voxels);
      const auto shared = std::make_shared<const Image>(std::move(image));
      auto regions = regions_of_labels(*shared, {});
      find_certain_size(*shared, {}, regions, 1);
      ASSERT_EQ(regions[1].certain_size, 0.5 * edge);
      const Labels labels = of_points(*label_domain(shared, {}, {0.5 * edge, 1}));
      bool found = false;
      for (const auto& [point, label] : labels) {
        const auto is = [&, p = point](int x, int y, int z) {
          const auto other = labels.find({p[0] + x, p[1] + y, p[2] + z});
          return other != labels.end() && other->second == 7;
        };
        found = found || (label == 7 && is(2, 0, 0) && is(1, 1, 1) && is(1, 1, -1));
      }
      EXPECT_TRUE(found) << edge << ' ' << shift;
    }
}

}  // namespace
}  // namespace certet
