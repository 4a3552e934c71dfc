#pragma once
/// \file
/// Vertices of certified stencils, which are handles there, by their places.

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/stencil.hpp"
#include "certified.hpp"

/// A lattice point twice, or the ends of a cut edge.
using Place = std::pair<certet::Coord3, certet::Coord3>;
using PlacedTets = std::vector<std::array<Place, 4>>;

/// The four corners, handles 0 to 3, and cuts as they are asked for.
class VertexArena {
 public:
  explicit VertexArena(const std::array<certet::Coord3, 4>& corners) : corners_(corners) {
    for (const certet::Coord3 c : corners) places_.emplace_back(c, c);
  }

  static std::size_t corner(certified::Handle h) {
    if (h < 0 || h >= 4) throw std::logic_error("a cut was taken for a corner");
    return static_cast<std::size_t>(h);
  }
  certified::Handle cut(certified::Handle a, certified::Handle b) {
    places_.emplace_back(corners_[corner(a)], corners_[corner(b)]);
    return static_cast<certified::Handle>(places_.size() - 1);
  }
  [[nodiscard]] const Place& at(certified::Handle h) const {
    return places_.at(static_cast<std::size_t>(h));
  }

  template <class Tets>
  [[nodiscard]] PlacedTets placed(const Tets& tets) const {
    PlacedTets placed;
    for (const auto& tet : tets)
      for (std::size_t i = 0; auto& p : placed.emplace_back()) p = at(tet[i++]);
    return placed;
  }

 private:
  std::array<certet::Coord3, 4> corners_;
  std::vector<Place> places_;
};

inline PlacedTets place(const certet::Stencil& stencil,
                        const std::array<certet::Coord3, 4>& corners) {
  PlacedTets tets;
  for (const certet::UnstructuredTet& tet : stencil)
    for (std::size_t i = 0; auto& p : tets.emplace_back()) {
      p = {corners[tet[i].a], corners[tet[i].b]};
      ++i;
    }
  return tets;
}
