#include "make_tile.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "fields/smoothed_labels.hpp"
#include "fields/thin.hpp"

namespace certet::fields {
namespace {

/// The fields of a whole tile, and what its blocks take from them.
class TileFields {
 public:
  TileFields(const LabelWindow& window, const Rules& rules) : window_(window) {
    wide_.compute(window, rules.taps);
    const auto whole = whole_blocks(window);
    find_at_risk(window, whole, at_risk_);
    if (!rules.narrow_thin || !find_thin(window, whole, thin_)) return;
    some_thin_ = true;
    std::array<Taps, 3> taps;
    for (std::size_t a = 0; a < 3; ++a) taps[a] = narrower(rules.taps[a], thin_taps());
    narrow_.compute(window, taps);
  }

  /// Appends a block to a tile; `corner` is its first node.
  void add_block(const std::array<int, 3>& corner, Block& block, Tile& tile) {
    block.first = static_cast<std::uint32_t>(tile.materials.size());
    for (std::size_t rank = 0; rank < window_.materials.size(); ++rank) {
      if (!gather(rank, corner)) continue;
      block_rank_[rank] = block.labels++;
      tile.materials.push_back(window_.materials[rank]);
      tile.values.insert(tile.values.end(), gathered_.begin(), gathered_.end());
    }
    if (block.labels == 1) {
      block = {tile.materials.back(), 0, 0, 0};
      tile.materials.pop_back();
      tile.values.resize(tile.values.size() - nodes_of_block);
      return;
    }
    block.nodes = static_cast<std::uint16_t>(tile.nodes.size() / nodes_of_block);
    add_nodes(corner, tile);
  }

 private:
  /// The values of a label in a block.  \returns whether there is one that is not 0.
  bool gather(std::size_t rank, const std::array<int, 3>& corner) {
    unsigned some = 0;
    auto out = gathered_.begin();
    for (int z = corner[2]; z < corner[2] + block_nodes; ++z)
      for (int y = corner[1]; y < corner[1] + block_nodes; ++y, out += block_nodes) {
        const std::uint16_t* wide = wide_.row(rank, y, z);
        const std::uint16_t* narrow = some_thin_ ? narrow_.row(rank, y, z) : nullptr;
        if (wide == nullptr) {  // then the other is, too
          std::fill_n(out, block_nodes, std::int16_t{0});
          continue;
        }
        const bool* thin = some_thin_ ? &thin_[tile_node_number(0, y, z)] : nullptr;
        for (int x = 0; x < block_nodes; ++x) {
          const int at = corner[0] + x;
          std::uint16_t value = wide[at];
          if (thin != nullptr && thin[at]) value = narrow == nullptr ? 0 : narrow[at];
          out[x] = static_cast<std::int16_t>(value);
          some |= value;
        }
      }
    return some != 0;
  }

  void add_nodes(const std::array<int, 3>& corner, Tile& tile) const {
    for (int z = corner[2]; z < corner[2] + block_nodes; ++z)
      for (int y = corner[1]; y < corner[1] + block_nodes; ++y)
        for (int x = corner[0]; x < corner[0] + block_nodes; ++x) {
          const int halo = window_.halo;
          unsigned bits =
              block_rank_[window_.ranks[window_.at(x + halo, y + halo, z + halo)]];
          if (some_thin_ && thin_[tile_node_number(x, y, z)]) bits |= Node::thin_bit;
          if (at_risk_[tile_node_number(x, y, z)]) bits |= Node::at_risk_bit;
          tile.nodes.push_back({static_cast<std::uint16_t>(bits)});
        }
  }

  const LabelWindow& window_;
  SmoothedLabels wide_, narrow_;
  bool some_thin_ = false;
  NodeFlags thin_{}, at_risk_{};
  std::array<std::int16_t, nodes_of_block> gathered_{};
  std::vector<std::uint16_t> block_rank_ = std::vector<std::uint16_t>(window_.materials.size());
};

}  // namespace

int halo_of(const Rules& rules) {
  int halo = 2;  // what is thin depends on so many
  for (const Taps& taps : rules.taps) halo = std::max(halo, taps.radius());
  return halo;
}

std::unique_ptr<Tile> make_tile(const LabelWindow& window, const Rules& rules) {
  if (window.materials.size() == 1) return nullptr;
  auto tile = std::make_unique<Tile>();
  TileFields fields(window, rules);
  for_each_of_cube(tile_blocks, [&](int x, int y, int z) {
    fields.add_block({block_cells * x, block_cells * y, block_cells * z},
                     tile->blocks[block_number(x, y, z)], *tile);
  });
  tile->materials.shrink_to_fit();
  tile->values.shrink_to_fit();
  tile->nodes.shrink_to_fit();
  return tile;
}

}  // namespace certet::fields
