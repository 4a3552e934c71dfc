#pragma once
/// \file
/// The labels around one tile.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "fields/material_image.hpp"
#include "fields/treads.hpp"

namespace certet::fields {

/// The nodes of a tile and `halo` more on every side, as numbers of their labels.
struct LabelWindow {
  int halo = 0;
  int width = 0;                     ///< tile_nodes + 2 halo
  std::vector<Material> materials;   ///< that there are, ascending
  std::vector<std::uint16_t> ranks;  ///< of each node in `materials`; none if there is one
  /// Of each node the part that another label has, in 16384ths, and that one's rank; none
  /// where no node has such a part.
  std::vector<std::uint16_t> parts, receivers;

  [[nodiscard]] std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>((z * width + y) * width + x);
  }
};

/// `first` is the first node of the tile.
LabelWindow window_around(const MaterialImage& image, const Treads& treads,
                          const std::array<std::int64_t, 3>& first, int halo);

}  // namespace certet::fields
