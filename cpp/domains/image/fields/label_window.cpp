#include "label_window.hpp"

#include <algorithm>

#include "fields/field_tile.hpp"

namespace certet::fields {
namespace {

/// Ascending.
std::vector<Material> different_ones(const std::vector<MaterialRun>& runs) {
  std::vector<Material> found;
  for (const MaterialRun& run : runs)
    if (found.empty() || run.material != found.back()) found.push_back(run.material);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());  // clang 14 refuses ranges
  return found;
}

std::uint16_t rank_of(const LabelWindow& window, Material material) {
  return static_cast<std::uint16_t>(std::ranges::lower_bound(window.materials, material) -
                                    window.materials.begin());
}

void add_shares(const Treads& treads, const VoxelCube& cube, LabelWindow& window) {
  treads.for_each_within(cube, [&](const auto& voxel, std::uint16_t part, Material to) {
    const std::uint16_t rank = rank_of(window, to);
    // A label that lies beyond the window has no field there.
    if (rank == window.materials.size() || window.materials[rank] != to) return;
    window.parts.resize(window.ranks.size(), 0);
    window.receivers.resize(window.ranks.size(), 0);
    const std::size_t at = window.at(static_cast<int>(voxel[0] - cube.low[0]),
                                     static_cast<int>(voxel[1] - cube.low[1]),
                                     static_cast<int>(voxel[2] - cube.low[2]));
    window.parts[at] = part;
    window.receivers[at] = rank;
  });
}

}  // namespace

LabelWindow window_around(const MaterialImage& image, const Treads& treads,
                          const std::array<std::int64_t, 3>& first, int halo) {
  LabelWindow window;
  window.halo = halo;
  window.width = tile_nodes + 2 * halo;
  VoxelCube cube{{}, window.width};
  // Node n is voxel n - 1.
  for (std::size_t a = 0; a < 3; ++a) cube.low[a] = first[a] - 1 - halo;
  std::vector<MaterialRun> runs;
  image.append_runs(cube, runs);
  window.materials = different_ones(runs);
  if (window.materials.size() == 1) return window;
  window.ranks.resize(static_cast<std::size_t>(window.width * window.width * window.width));
  auto voxel = window.ranks.begin();
  for (const MaterialRun& run : runs)
    voxel = std::fill_n(voxel, run.length, rank_of(window, run.material));
  add_shares(treads, cube, window);
  return window;
}

}  // namespace certet::fields
