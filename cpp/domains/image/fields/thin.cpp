#include "thin.hpp"

#include <algorithm>

#include "fields/octants.hpp"

namespace certet::fields {
namespace {

bool at_risk(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
             std::size_t voxel) {
  const Octants own = whole[voxel];
  if (own == 0 || !hang_together(own)) return true;
  std::size_t stride = 1;
  for (const Octants upper : upper_octants) {
    const auto lower = static_cast<Octants>(~upper);
    if (window.ranks[voxel + stride] == window.ranks[voxel] && (own & upper) == 0) return true;
    if (window.ranks[voxel - stride] == window.ranks[voxel] && (own & lower) == 0) return true;
    stride *= static_cast<std::size_t>(window.width);
  }
  return false;
}

/// Whether at most two in a row have the label of a voxel.
bool is_short(const std::uint16_t* rank, std::size_t along) {
  const bool before = rank[0] == *(rank - along), after = rank[0] == rank[along];
  if (before == after) return !before;
  return before ? rank[0] != *(rank - 2 * along) : rank[0] != rank[2 * along];
}

using Strides = std::array<std::size_t, 3>;

Slender slender_along(const std::uint16_t* rank, std::size_t along, const Strides& strides) {
  if (!is_short(rank, along)) return Slender::no;
  for (const std::size_t beside : strides) {
    if (beside == along) continue;
    for (const std::uint16_t* other : {rank - beside, rank + beside})
      if (*other == *rank && !is_short(other, along)) return Slender::row;
  }
  return Slender::part;
}

}  // namespace

/// In loops over all voxels, as if each row went on in the next one: that is wrong in
/// the outermost voxels alone.
std::vector<std::uint8_t> whole_blocks(const LabelWindow& window) {
  const auto row = static_cast<std::size_t>(window.width);
  const auto distance = [&](std::size_t o) {
    return (o & 1) + (o >> 1 & 1) * row + (o >> 2) * row * row;
  };
  const std::size_t count = window.ranks.size() - distance(7);
  std::vector<std::uint8_t> whole(count, 1);  // of the block from a voxel upwards
  const std::uint16_t* rank = window.ranks.data();
  for (std::size_t o = 1; o < 8; ++o)
    for (std::size_t v = 0; v < count; ++v)
      whole[v] = static_cast<std::uint8_t>(whole[v] & (rank[v] == rank[v + distance(o)] ? 1 : 0));
  std::vector<std::uint8_t> octants(window.ranks.size(), 0);
  for (std::size_t o = 0; o < 8; ++o) {
    // The block lies in octant 7 - o of its voxel o.
    std::uint8_t* of_voxel = octants.data() + distance(o);
    for (std::size_t v = 0; v < count; ++v)
      of_voxel[v] = static_cast<std::uint8_t>(of_voxel[v] | whole[v] << (7 - o));
  }
  return octants;
}

bool find_thin(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
               NodeFlags& flags) {
  flags.fill(false);
  bool some = false;
  for (int z = -1; z <= tile_nodes; ++z)
    for (int y = -1; y <= tile_nodes; ++y)
      for (int x = -1; x <= tile_nodes; ++x) {
        if (whole[window.at(x + window.halo, y + window.halo, z + window.halo)] != 0) continue;
        for (int k = std::max(z - 1, 0); k <= std::min(z + 1, tile_nodes - 1); ++k)
          for (int j = std::max(y - 1, 0); j <= std::min(y + 1, tile_nodes - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, tile_nodes - 1); ++i)
              some = flags[tile_node_number(i, j, k)] = true;
      }
  return some;
}

void find_slender(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
                  Slenderness& slender) {
  const auto width = static_cast<std::size_t>(window.width);
  const Strides strides{1, width, width * width};
  for_each_of_cube(tile_nodes, [&](int x, int y, int z) {
    const std::size_t voxel = window.at(x + window.halo, y + window.halo, z + window.halo);
    Slender& most = slender[tile_node_number(x, y, z)] = Slender::no;
    if (whole[voxel] == 0xff) return;
    for (const std::size_t along : strides)
      most = std::max(most, slender_along(&window.ranks[voxel], along, strides));
    if (most == Slender::part && whole[voxel] == 0) most = Slender::thin_part;
  });
}

void find_at_risk(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
                  NodeFlags& flags) {
  for_each_of_cube(tile_nodes, [&](int x, int y, int z) {
    flags[tile_node_number(x, y, z)] =
        at_risk(window, whole, window.at(x + window.halo, y + window.halo, z + window.halo));
  });
}

}  // namespace certet::fields
