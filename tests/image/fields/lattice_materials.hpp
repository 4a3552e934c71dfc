#pragma once
/// \file
/// What a domain says of all points and edges of its lattice.

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "certet/image.hpp"
#include "fields/fields_domain.hpp"

namespace lattice_materials {

using certet::Coord3;
using certet::Material;
using certet::PartedEdge;

inline std::unique_ptr<certet::InterfaceDomain> domain_of(certet::Image image, double size = 1,
                                                         const certet::fields::Rules& rules = {},
                                                         int threads = 1) {
  certet::Context context;
  context.threads = threads;
  return certet::fields::fields_domain(std::make_shared<const certet::Image>(std::move(image)),
                                       {}, {size, 1}, rules, context);
}

/// Half of the edges of a lattice point; the others are those of its neighbours.
inline const std::vector<Coord3> half_of_edges{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 1},
                                               {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

class LatticeMaterials {
 public:
  explicit LatticeMaterials(const certet::PlacedDomain& domain) : lattice_(domain.lattice()) {
    std::vector<Material> row(static_cast<std::size_t>(lattice_.cells[0]));
    for (std::size_t odd = 0; odd < 2; ++odd)
      for (int k = 0; k < lattice_.cells[2]; ++k)
        for (int j = 0; j < lattice_.cells[1]; ++j) {
          domain.row_materials(point(odd, 0, j, k), row);
          all_.insert(all_.end(), row.begin(), row.end());
        }
  }

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  /// The number of a point; `nowhere` beyond the lattice.
  [[nodiscard]] std::size_t number(Coord3 at) const {
    const Coord3 p = at - lattice_.origin;
    const int odd = p.x & 1;
    const int i = (p.x - odd) / 2, j = (p.y - odd) / 2, k = (p.z - odd) / 2;
    if (p.x < 0 || p.y < 0 || p.z < 0 || i >= lattice_.cells[0] || j >= lattice_.cells[1] ||
        k >= lattice_.cells[2])
      return nowhere;
    return static_cast<std::size_t>(
        ((odd * lattice_.cells[2] + k) * lattice_.cells[1] + j) * lattice_.cells[0] + i);
  }

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] Material operator[](std::size_t number) const { return all_[number]; }
  [[nodiscard]] const std::vector<Material>& all() const { return all_; }

  /// Calls visit(point, number).
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::size_t number = 0;
    for (std::size_t odd = 0; odd < 2; ++odd)
      for (int k = 0; k < lattice_.cells[2]; ++k)
        for (int j = 0; j < lattice_.cells[1]; ++j)
          for (int i = 0; i < lattice_.cells[0]; ++i) visit(point(odd, i, j, k), number++);
  }

  /// Calls visit(first, number, second, number) for every edge.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for_each([&](Coord3 at, std::size_t one) {
      for (const Coord3 step : half_of_edges)
        if (const std::size_t other = number(at + step); other != nowhere)
          visit(at, one, at + step, other);
    });
  }

 private:
  [[nodiscard]] Coord3 point(std::size_t parity, int i, int j, int k) const {
    const int odd = static_cast<int>(parity);
    return lattice_.origin + Coord3{2 * i + odd, 2 * j + odd, 2 * k + odd};
  }

  certet::Lattice lattice_;
  std::vector<Material> all_;
};

/// All edges between different materials, from the higher to the lower, and their cuts.
struct Cuts {
  std::vector<PartedEdge> edges;
  std::vector<std::uint16_t> steps;

  explicit Cuts(const certet::PlacedDomain& domain) {
    const LatticeMaterials materials(domain);
    materials.for_each_edge([&](Coord3 a, std::size_t one, Coord3 b, std::size_t other) {
      const Material of_a = materials[one], of_b = materials[other];
      if (of_a > of_b) edges.push_back({a, b, of_b, of_a});
      if (of_a < of_b) edges.push_back({b, a, of_a, of_b});
    });
    steps.resize(edges.size());
    domain.part(edges, steps);
  }

  /// In steps.
  [[nodiscard]] Coord3 position(std::size_t e, std::int32_t further = 0) const {
    return certet::steps * edges[e].first +
           (std::int32_t{steps[e]} + further) * (edges[e].last - edges[e].first);
  }
};

}  // namespace lattice_materials
