#include "thin.hpp"

#include <algorithm>

#include "fields/octants.hpp"

namespace certet::fields {
namespace {

/// Calls visit(x, y, z) for every node of a tile.
template <class Visit>
void for_each_node(const Visit& visit) {
  for (int z = 0; z < tile_nodes; ++z)
    for (int y = 0; y < tile_nodes; ++y)
      for (int x = 0; x < tile_nodes; ++x) visit(x, y, z);
}

std::size_t flag_number(int x, int y, int z) {
  return static_cast<std::size_t>((z * tile_nodes + y) * tile_nodes + x);
}

/// Whether the block of 2 x 2 x 2 voxels from this one upwards has one label.
bool is_whole(const LabelWindow& window, std::size_t from) {
  const std::uint16_t label = window.ranks[from];
  const auto row = static_cast<std::size_t>(window.width);
  for (const std::size_t other : {from, from + row, from + row * row, from + row * row + row})
    if (window.ranks[other] != label || window.ranks[other + 1] != label) return false;
  return true;
}

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

}  // namespace

std::vector<std::uint8_t> whole_blocks(const LabelWindow& window) {
  std::vector<std::uint8_t> octants(window.ranks.size(), 0);
  const int last = window.width - 1;
  for (int z = 0; z < last; ++z)
    for (int y = 0; y < last; ++y)
      for (int x = 0; x < last; ++x) {
        if (!is_whole(window, window.at(x, y, z))) continue;
        // It is the block in octant 7 - o of its voxel o.
        for (int o = 0; o < 8; ++o)
          octants[window.at(x + (o & 1), y + (o >> 1 & 1), z + (o >> 2))] |=
              static_cast<std::uint8_t>(1U << (7 - o));
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
              some = flags[flag_number(i, j, k)] = true;
      }
  return some;
}

void find_at_risk(const LabelWindow& window, const std::vector<std::uint8_t>& whole,
                  NodeFlags& flags) {
  for_each_node([&](int x, int y, int z) {
    flags[flag_number(x, y, z)] =
        at_risk(window, whole, window.at(x + window.halo, y + window.halo, z + window.halo));
  });
}

}  // namespace certet::fields
