#pragma once
/// \file
/// What a tiling must be.

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "certet/lattice/orientation.hpp"
#include "certet/lattice/tiling.hpp"

namespace certet::tilings {

inline bool between_cells(Coord3 v) { return ((v.x | v.y | v.z) & 1) == 0; }

/// What is wrong with a tiling, each in a few words.
template <class AnyTiling>
std::set<std::string> defects(const AnyTiling& tiling) {
  std::set<std::string> wrong;
  std::int64_t volume = 0;
  const auto row = [&](const StructuredTetId& id) -> const StructuredTetShape& {
    return tiling.tets[static_cast<std::size_t>(id.orientation)];
  };
  for (std::size_t c = 0; c < tiling.tets.size(); ++c) {
    const StructuredTetShape& tet = tiling.tets[c];
    const auto& v = tet.vertices;
    const std::int64_t six = six_volume(v[0], v[1], v[2], v[3]);
    volume += six < 0 ? -six : six;
    if (six == 0 || (six > 0) != tet.right_handed) wrong.insert("hand");

    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [id, order] = tet.neighbors[i];
      if (!between_cells(id.anchor) || static_cast<std::size_t>(id.orientation) >= tiling.tets.size()) {
        wrong.insert("neighbour");
        continue;
      }
      auto u = row(id).vertices;
      for (Coord3& corner : u) corner = id.anchor + corner;
      u = certet::apply(order, u);
      for (std::size_t j = 0; j < 4; ++j)
        if ((u[j] == v[j]) != (j != i)) wrong.insert("neighbour");
      // The other way: somebody of the neighbour's neighbours is this one.
      bool back = false;
      for (const FaceNeighbor& n : row(id).neighbors)
        back = back || (id.anchor + n.id.anchor == Coord3{0, 0, 0} &&
                        static_cast<std::size_t>(n.id.orientation) == c);
      if (!back) wrong.insert("neighbour of the neighbour");
    }

    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        int families = 0;
        for (const auto& edge : tiling.edges)
          families += (edge.second - edge.first == v[a] - v[b] && between_cells(v[b] - edge.first)) ||
                      (edge.second - edge.first == v[b] - v[a] && between_cells(v[a] - edge.first));
        if (families != 1) wrong.insert("edge");
        bool forward = false;
        bool backward = false;
        for (const Coord3& d : tiling.directions) {
          forward = forward || d == v[a] - v[b];
          backward = backward || d == v[b] - v[a];
        }
        if (!forward || !backward) wrong.insert("direction");
      }
  }
  if (volume != 6 * 8) wrong.insert("volume");  // that of a cell
  return wrong;
}

}  // namespace certet::tilings
