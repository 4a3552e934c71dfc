#include "samples.hpp"

#include <algorithm>
#include <cstdlib>

#include "certet/lattice/direction.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "domains.hpp"

namespace labelled {

Samples::Samples(const certet::Domain& domain, const certet::Lattice& lattice)
    : lattice_(lattice) {
  const auto [nx, ny, nz] = lattice.cells;
  std::vector<Material> row(static_cast<std::size_t>(nx));
  for (std::int32_t odd = 0; odd < 2; ++odd)
    for (std::int32_t k = 0; k < nz; ++k)
      for (std::int32_t j = 0; j < ny; ++j) {
        const Coord3 first = lattice.origin + Coord3{odd, 2 * j + odd, 2 * k + odd};
        domain.row_materials(first, row);
        const bool outer = j == 0 || k == 0 || j == ny - 1 || k == nz - 1;
        for (std::int32_t i = 0; i < nx; ++i) {
          vertices_.push_back(first + Coord3{2 * i, 0, 0});
          materials_.push_back(outer || i == 0 || i == nx - 1 ? 0 : row[static_cast<std::size_t>(i)]);
        }
      }
  for (const Coord3 v : vertices_) {
    MaterialSet found = MaterialSet{1} << at(v);
    for (const Coord3 offset : certet::direction_offset) found |= MaterialSet{1} << at(v + offset);
    around_.push_back(found);
  }
}

bool Samples::holds(Coord3 v) const {
  const Coord3 d = v - lattice_.origin;
  return d.x >= 0 && d.y >= 0 && d.z >= 0 && d.x < 2 * lattice_.cells[0] &&
         d.y < 2 * lattice_.cells[1] && d.z < 2 * lattice_.cells[2];
}

std::size_t Samples::number(Coord3 v) const {
  const Coord3 d = v - lattice_.origin;
  const auto [nx, ny, nz] = lattice_.cells;
  return static_cast<std::size_t>((((d.x & 1) * nz + d.z / 2) * ny + d.y / 2) * nx + d.x / 2);
}

Material Samples::at(Coord3 v) const { return holds(v) ? materials_[number(v)] : 0; }
MaterialSet Samples::around(Coord3 v) const { return holds(v) ? around_[number(v)] : 1; }

topology::Shape Samples::shape(MaterialSet materials) const {
  return topology::of_samples(vertices_,
                              [&](Coord3 v) { return (materials >> at(v) & 1) != 0; });
}

bool Samples::may_touch_itself(Material material, Coord3 position) const {
  const auto [first, last, t] = domains::edge_of(position);
  const Coord3 along = last - first;
  if (t == 0 || std::abs(along.x) + std::abs(along.y) + std::abs(along.z) != 2) return false;
  if (at(first) == at(last) || at(first) == material || at(last) == material) return false;
  // The other two axes, across which its ring of four lies.
  const Coord3 u = along.x == 0 ? Coord3{1, 0, 0} : Coord3{0, 1, 0};
  const Coord3 v = along.z == 0 ? Coord3{0, 0, 1} : Coord3{0, 1, 0};
  const Coord3 middle{first.x + along.x / 2, first.y + along.y / 2, first.z + along.z / 2};
  const auto has = [&](int a, int b) { return at(middle + a * u + b * v) == material; };
  const bool one = has(1, 1) && has(-1, -1), other = has(1, -1) && has(-1, 1);
  return (one && other) || (one && !has(1, -1) && !has(-1, 1)) ||
         (other && !has(1, 1) && !has(-1, -1));
}

VolumeBounds Samples::volume(MaterialSet materials) const {
  constexpr exact::Wide whole = exact::Wide{4} << (3 * certet::step_bits);
  VolumeBounds bounds;
  for (const Coord3 v : vertices_) {
    if ((v.x & 1) != 0) continue;
    for (const certet::StructuredTetShape& shape : certet::structured_tet_table) {
      MaterialSet found = 0;
      for (const Coord3 corner : shape.vertices) found |= around(v + corner);
      if ((found & ~materials) == 0) bounds.least += whole;
      if ((found & materials) != 0) bounds.most += whole;
    }
  }
  return bounds;
}

}  // namespace labelled
