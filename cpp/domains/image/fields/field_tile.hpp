#pragma once
/// \file
/// How fields are kept: in blocks of 4 x 4 x 4 cells, and only where labels meet.
///
/// Nodes are the centres of voxels and one more before and behind them along every
/// axis, so that cells, which lie between nodes, cover the image: node n is the centre
/// of voxel n - 1, and those added are copies of their neighbours.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "certet/domain.hpp"
#include "fields/field_point.hpp"

namespace certet::fields {

inline constexpr int block_cells = 4;  ///< along an axis
inline constexpr int block_nodes = block_cells + 1;
inline constexpr std::size_t nodes_of_block = block_nodes * block_nodes * block_nodes;
inline constexpr int tile_blocks = 4;  ///< a tile has 4 x 4 x 4 blocks
inline constexpr int tile_cells = tile_blocks * block_cells;
inline constexpr int tile_nodes = tile_cells + 1;
inline constexpr std::size_t blocks_of_tile = tile_blocks * tile_blocks * tile_blocks;

/// A field is kept in 16384ths.
inline constexpr int field_bits = 14;
inline constexpr std::int32_t field_one = 1 << field_bits;

/// What is known of a node beside the fields: the number of its voxel's label among
/// those of the block, three flags, and how far that label is to be ahead of all others.
struct Node {
  static constexpr std::uint16_t at_risk_bit = 1 << 14, thin_bit = 1 << 15;
  static constexpr std::uint16_t firm_bit = 1 << 15;  ///< of the lead
  std::uint16_t bits = 0;
  std::uint16_t lead_bits = 0;
  [[nodiscard]] std::size_t own() const { return bits & (at_risk_bit - 1); }
  /// Whether its voxel may be lost where no point of the lattice is at its centre.
  [[nodiscard]] bool at_risk() const { return (bits & at_risk_bit) != 0; }
  /// In 16384ths.
  [[nodiscard]] std::int32_t lead() const { return lead_bits & (firm_bit - 1); }
  /// Whether constants are not to make a hole there, as in a sheet one voxel thick.
  [[nodiscard]] bool firm() const { return (lead_bits & firm_bit) != 0; }
  /// Whether the narrow taps were taken.
  [[nodiscard]] bool thin() const { return (bits & thin_bit) != 0; }
};

/// A bit for each cell of a block, the first axis running fastest.
using CellSet = std::uint64_t;

/// The number of a cell in its block.
constexpr unsigned cell_number(const Cell& cell) {
  constexpr std::int64_t mask = block_cells - 1;
  return static_cast<unsigned>((cell[0] & mask) | (cell[1] & mask) * block_cells |
                               (cell[2] & mask) * (block_cells * block_cells));
}

/// A block of a tile.  Where several labels are near, `values` has one field after the
/// other, each of 125 nodes, the first axis running fastest; a label that no voxel in
/// reach of a node has is 0 there.
struct Block {
  Material only = 0;            ///< where there is but one
  std::uint16_t labels = 0;     ///< 0: one
  std::uint16_t nodes = 0;      ///< where the block stands among those of several labels
  std::uint32_t first = 0;      ///< of its labels in the tile's list
  CellSet parted = 0;           ///< the cells whose corners are voxels of several labels
  CellSet at_risk = 0;          ///< those that have a corner at risk
};

static_assert((block_cells & (block_cells - 1)) == 0 && tile_blocks == 4, "bits number them");

/// The number of a node in a block.
constexpr std::size_t node_number(int x, int y, int z) {
  return static_cast<std::size_t>((z * block_nodes + y) * block_nodes + x);
}

/// The number of a node in a tile.
constexpr std::size_t tile_node_number(int x, int y, int z) {
  return static_cast<std::size_t>((z * tile_nodes + y) * tile_nodes + x);
}

/// Calls visit(x, y, z) for each of `count` numbers along three axes.
template <class Visit>
void for_each_of_cube(int count, const Visit& visit) {
  for (int z = 0; z < count; ++z)
    for (int y = 0; y < count; ++y)
      for (int x = 0; x < count; ++x) visit(x, y, z);
}

/// The number of a block in a tile.
constexpr std::size_t block_number(int x, int y, int z) {
  return static_cast<std::size_t>((z * tile_blocks + y) * tile_blocks + x);
}

/// The number of a cell's first node in its block.
constexpr std::size_t first_node_number(const Cell& cell) {
  constexpr std::int64_t mask = block_cells - 1;
  return static_cast<std::size_t>(((cell[2] & mask) * block_nodes + (cell[1] & mask)) * block_nodes +
                                  (cell[0] & mask));
}

/// What a block holds, wherever it is kept.
struct BlockView {
  Material only = 0;
  std::size_t labels = 0;  ///< 0: there is but one
  const Material* materials = nullptr;
  const Node* nodes = nullptr;
  const std::int16_t* values = nullptr;
  CellSet parted = 0, at_risk = 0;
};

struct Tile {
  std::array<Block, blocks_of_tile> blocks{};
  std::vector<Material> materials;   ///< of the labels of all blocks, ascending in each
  std::vector<std::int16_t> values;  ///< 125 for each element of `materials`
  std::vector<Node> nodes;           ///< 125 for each block of several labels

  [[nodiscard]] BlockView view(const Block& block) const {
    if (block.labels == 0) return {.only = block.only};
    return {0, block.labels, &materials[block.first], &nodes[nodes_of_block * block.nodes],
            &values[nodes_of_block * block.first], block.parted, block.at_risk};
  }

  [[nodiscard]] std::uint64_t bytes() const {
    return sizeof(*this) + materials.size() * sizeof(materials[0]) +
           values.size() * sizeof(values[0]) + nodes.size() * sizeof(nodes[0]);
  }
};

}  // namespace certet::fields
