#pragma once
/// \file
/// Whole meshes, tetrahedron by tetrahedron, of the engine and of the reference.

#include <algorithm>
#include <sstream>
#include <vector>

#include "certet/stuffing.hpp"
#include "certified.hpp"
#include "differences.hpp"

/// A mesh with the method that it was made by in the end.
struct PlacedMesh {
  std::vector<certified::PlacedTet> tets;
  certet::Method method{};
};

inline PlacedMesh placed_mesh(const certet::Stuffing& stuffing, certet::Context& context) {
  const certet::Mesh mesh = certet::emit(stuffing, {}, context);
  PlacedMesh placed{{}, stuffing.method()};
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets)
          placed.tets.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
      },
      mesh.tets);
  return placed;
}

/// As many, and each the same as the other's in its place.
inline Differences compare_tets(const std::vector<certified::PlacedTet>& ours,
                                const std::vector<certified::PlacedTet>& theirs) {
  Differences differences;
  differences.expect(ours.size() == theirs.size(), [&] {
    std::ostringstream out;
    out << ours.size() << " tetrahedra instead of " << theirs.size();
    return out.str();
  });
  for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i)
    differences.expect(ours[i] == theirs[i], [&] {
      std::ostringstream out;
      out << "tetrahedron " << i;
      for (const auto* tet : {&ours[i], &theirs[i]}) {
        out << (tet == &theirs[i] ? " instead of" : ":");
        for (const certet::Coord3 v : *tet) out << " (" << v.x << ' ' << v.y << ' ' << v.z << ')';
      }
      return out.str();
    });
  return differences;
}
