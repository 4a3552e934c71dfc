#pragma once
/// \file
/// Whole meshes of several materials, of the engine and of the reference.

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <variant>
#include <vector>

#include "certet/mesh.hpp"
#include "certified.hpp"
#include "differences.hpp"
#include "materials.hpp"

using MaterialMesh = std::vector<certified::PlacedMaterialTet>;

inline MaterialMesh placed_by_material(const certet::Mesh& mesh) {
  MaterialMesh placed;
  std::visit(
      [&](const auto& tets) {
        for (std::size_t n = 0; n < tets.size(); ++n) {
          const auto& [a, b, c, d] = tets[n];
          placed.push_back({mesh.labels[n],
                            {mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]}});
        }
      },
      mesh.tets);
  return placed;
}

/// As many, and each the same as the other's in its place.
inline Differences compare_by_material(const MaterialMesh& ours, const MaterialMesh& theirs) {
  Differences differences;
  differences.expect(ours.size() == theirs.size(), [&] {
    return std::to_string(ours.size()) + " tetrahedra instead of " + std::to_string(theirs.size());
  });
  for (std::size_t n = 0; n < std::min(ours.size(), theirs.size()); ++n)
    differences.expect(ours[n] == theirs[n], [&] {
      std::ostringstream out;
      out << "seed " << test_seed() << ", tetrahedron " << n;
      for (const auto* tet : {&ours[n], &theirs[n]}) {
        out << (tet == &theirs[n] ? " instead of " : ": ") << tet->material;
        for (const certet::Coord3 v : tet->vertices) out << " (" << materials::text(v) << ')';
      }
      return out.str();
    });
  return differences;
}

/// The material of a lattice point; the outermost are outside.
inline certet::Material sample(const materials::Positional& domain, const certet::Lattice& lattice,
                               certet::Coord3 v) {
  const auto is_inner = [](std::int32_t from_origin, std::int32_t cells) {
    return 2 <= from_origin && from_origin / 2 < cells - 1;
  };
  const certet::Coord3 d = v - lattice.origin;
  const auto [nx, ny, nz] = lattice.cells;
  if (!is_inner(d.x, nx) || !is_inner(d.y, ny) || !is_inner(d.z, nz)) return 0;
  return domain.material_at(certet::steps * v);
}

/// Where an edge leaves the higher of two materials, in steps from that end.
inline std::int64_t cut_of(const materials::Positional& domain, const certet::Lattice& lattice,
                           certet::Coord3 higher, certet::Coord3 lower) {
  const certet::Material last = sample(domain, lattice, lower);
  return certified::bisect([&](std::int64_t t) {
    const bool beyond = domain.material_at(certified::point_on_edge(higher, lower, t)) == last;
    return beyond ? certet::Sign::minus : certet::Sign::plus;
  });
}

/// A domain on a lattice as the certified functions see it; both outlive what is returned.
inline certified::MaterialDomain seen_on(const certet::Lattice& lattice,
                                         const materials::Positional& domain) {
  using certet::Coord3;
  return {[&](Coord3 v) -> certified::Material { return domain.material_at(certet::steps * v); },
          [&](Coord3 higher, Coord3 lower) { return cut_of(domain, lattice, higher, lower); }};
}
