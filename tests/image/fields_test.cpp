// Smooth interfaces between labels: how far they are from the truth, and what they keep.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "certet/image.hpp"
#include "fields/fields_domain.hpp"
#include "label_images.hpp"

namespace certet {
namespace {

using label_images::Balls;

std::unique_ptr<InterfaceDomain> domain_of(Image image, double size = 1,
                                           const fields::Rules& rules = {}, int threads = 1) {
  Context context;
  context.threads = threads;
  return fields::fields_domain(std::make_shared<const Image>(std::move(image)), {}, {size, 1},
                               rules, context);
}

/// Half of the edges of a lattice point; the others are those of its neighbours.
const std::vector<Coord3> half_of_edges{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 1},
                                        {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

/// The materials of all lattice points.
class LatticeMaterials {
 public:
  explicit LatticeMaterials(const PlacedDomain& domain)
      : lattice_(domain.lattice()) {
    for (int odd = 0; odd < 2; ++odd)
      for (int k = 0; k < lattice_.cells[2]; ++k)
        for (int j = 0; j < lattice_.cells[1]; ++j) {
          std::vector<Material> row(static_cast<std::size_t>(lattice_.cells[0]));
          domain.row_materials(lattice_.origin + Coord3{odd, 2 * j + odd, 2 * k + odd}, row);
          all_[odd].insert(all_[odd].end(), row.begin(), row.end());
        }
  }

  /// -1 beyond the lattice.
  [[nodiscard]] Material at(Coord3 point) const {
    const Coord3 p = point - lattice_.origin;
    const int odd = p.x & 1;
    const int i = (p.x - odd) / 2, j = (p.y - odd) / 2, k = (p.z - odd) / 2;
    if (p.x < 0 || p.y < 0 || p.z < 0 || i >= lattice_.cells[0] || j >= lattice_.cells[1] ||
        k >= lattice_.cells[2])
      return -1;
    return all_[odd][static_cast<std::size_t>((k * lattice_.cells[1] + j) * lattice_.cells[0] + i)];
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int odd = 0; odd < 2; ++odd)
      for (int k = 0; k < lattice_.cells[2]; ++k)
        for (int j = 0; j < lattice_.cells[1]; ++j)
          for (int i = 0; i < lattice_.cells[0]; ++i)
            visit(lattice_.origin + Coord3{2 * i + odd, 2 * j + odd, 2 * k + odd});
  }

 private:
  Lattice lattice_;
  std::array<std::vector<Material>, 2> all_;
};

/// All edges between different materials, from the higher to the lower.
std::vector<PartedEdge> parted_edges(const LatticeMaterials& materials) {
  std::vector<PartedEdge> edges;
  materials.for_each([&](Coord3 point) {
    for (const Coord3 step : half_of_edges) {
      const Material one = materials.at(point), other = materials.at(point + step);
      if (other < 0 || one == other) continue;
      if (one > other) edges.push_back({point, point + step, other});
      else edges.push_back({point + step, point, one});
    }
  });
  return edges;
}

/// World positions of all cuts.
std::vector<Point3> cuts_of(const PlacedDomain& domain) {
  const std::vector<PartedEdge> edges = parted_edges(LatticeMaterials(domain));
  std::vector<std::uint16_t> cuts(edges.size());
  domain.part(edges, cuts);
  std::vector<Point3> points;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Coord3 towards = edges[e].last - edges[e].first;
    points.push_back(domain.frame().world(steps * edges[e].first + std::int32_t{cuts[e]} * towards));
  }
  return points;
}

/// Distances from the truth.
struct Deviation {
  double greatest = 0, rms = 0;
  std::size_t count = 0;
  template <class Distance>
  Deviation(const std::vector<Point3>& points, const Distance& distance) : count(points.size()) {
    for (const Point3& p : points) {
      const double d = std::abs(distance(p));
      greatest = std::max(greatest, d);
      rms += d * d;
    }
    rms = std::sqrt(rms / static_cast<double>(count));
  }
};

TEST(Fields, BallsAreNearTheTruth) {
  const Balls balls(64);
  const auto domain = domain_of(balls.image());
  const Deviation deviation(cuts_of(*domain), [&](const Point3& p) { return balls.distance(p); });
  std::cout << deviation.count << " cuts, greatest " << deviation.greatest << ", rms "
            << deviation.rms << '\n';
  EXPECT_LE(deviation.greatest, 0.6);
  EXPECT_LE(deviation.rms, 0.2);
  for (const RegionVolume& region : domain->volumes())
    std::cout << region.label << ' ' << region.voxels << ' ' << region.volume << '\n';
}

}  // namespace
}  // namespace certet
