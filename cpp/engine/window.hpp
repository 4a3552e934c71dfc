#pragma once
/// \file
/// A part of the lattice: some of its layers, whole ones.
///
/// Every stage works on a window, which may be a slab of the lattice, the share
/// of one of several machines, or all of it; the rim, where the mesh is closed,
/// belongs to the lattice and not to the window.  What a stage decides of a layer
/// depends on a few layers around it, so that each stage works on a wider window
/// than the stage that it works for (picture: cpp/docs/pictures/windows.svg):
///
///     layer           -2  -1 | 0 … n-1 | n  n+1  n+2
///     signs            x   x |    x    | x   x    x    sampled_window
///     cuts             x   x |    x    | x   x         cut_window
///     violations           x |    x    | x   x         violation_window
///     warped signs           |    x    | x             warped_window
///     numbers of points      |    x    | x
///     points, tetrahedra     |    x    |               the window itself
///
/// A cut of layer k lies between signs of the layers k and k + 1, and violates
/// vertices of either; a zero vertex remains if a neighbour, in layers k - 1 to
/// k + 1, is plus after warping; tetrahedra of layer k use points of the layers k
/// and k + 1.  (A zero vertex of layer n + 1 may be taken for one that remains:
/// if it does not it has no plus neighbour, and no edge to it is cut.)
///
/// That is so where each violated vertex moves, whatever becomes of the others.
/// Where they settle one after the other, in 32 turns, each looks at its neighbours
/// as they are at its turn, and these looked at theirs in the turns before: the
/// violations, cuts and signs of 31 more layers on each side are needed, the `halo`.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/lattice.hpp"

namespace certet::core {

/// The layers [begin, end) of a lattice.
struct Window {
  std::int32_t begin, end;
  [[nodiscard]] constexpr std::int32_t layers() const { return end - begin; }
  [[nodiscard]] constexpr bool contains(std::int32_t k) const { return begin <= k && k < end; }
};

/// All layers.
constexpr Window whole(const Lattice& lattice) { return {0, lattice.cells[2]}; }

/// The window and so many layers before and behind it, as far as there are any.
constexpr Window widened(Window window, std::int32_t before, std::int32_t behind,
                         const Lattice& lattice) {
  return {std::max(window.begin - before, 0), std::min(window.end + behind, lattice.cells[2])};
}

/// The halo of the method by which violated vertices settle.
inline constexpr std::int32_t settling_halo = 31;

/// Where signs are sampled, for the mesh of `window`.
constexpr Window sampled_window(Window window, const Lattice& lattice, std::int32_t halo) {
  return widened(window, 2 + halo, 3 + halo, lattice);
}
/// Where cuts are found.
constexpr Window cut_window(Window window, const Lattice& lattice, std::int32_t halo) {
  return widened(window, 2 + halo, 2 + halo, lattice);
}
/// Where violated vertices are found.
constexpr Window violation_window(Window window, const Lattice& lattice, std::int32_t halo) {
  return widened(window, 1 + halo, 2 + halo, lattice);
}
/// Where the signs after warping are known.
constexpr Window warped_window(Window window, const Lattice& lattice) {
  return widened(window, 0, 1, lattice);
}

/// A value for each layer of a window.
template <class T>
class Layers {
 public:
  explicit Layers(Window window)
      : window_(window), values_(static_cast<std::size_t>(window.layers())) {}

  [[nodiscard]] Window window() const { return window_; }
  [[nodiscard]] T& operator[](std::int32_t k) { return values_[at(k)]; }
  [[nodiscard]] const T& operator[](std::int32_t k) const { return values_[at(k)]; }

  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }

 private:
  [[nodiscard]] std::size_t at(std::int32_t k) const {
    return static_cast<std::size_t>(k - window_.begin);
  }

  Window window_;
  std::vector<T> values_;
};

}  // namespace certet::core
