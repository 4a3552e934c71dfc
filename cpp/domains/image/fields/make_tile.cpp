#include "make_tile.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "fields/smoothed_labels.hpp"
#include "fields/thin.hpp"

namespace certet::fields {
namespace {

/// By how much the own label is ahead at least: by no more, or single voxels would stand out
/// of smooth surfaces; but near thin voxels by a quarter, or a constant that raises a thin label
/// would add little to it.
constexpr std::int32_t least_lead = field_one / 64, thin_lead = field_one / 4;

/// The same by the own label's value, where one or two voxels are in a row.
constexpr std::int32_t row_lead(std::int32_t own) { return 3 * field_one / 4 - own; }
/// In sheets and wires: what brings the surface to the faces of voxels in a sheet along the
/// axes, where the value is 5/8, and near them in a wire.
constexpr std::int32_t part_lead(std::int32_t own) {
  return std::clamp(13 * field_one / 8 - 2 * own, 0, 5 * field_one / 4);
}
/// The same where they are one voxel thick, and the taps narrower.
constexpr std::int32_t thin_part_lead(std::int32_t own) {
  return std::clamp(55 * field_one / 32 - 7 * own / 4, 0, 5 * field_one / 4);
}

/// Which cells of a block have which corners.
void find_cells(const Node* nodes, Block& block) {
  // At a cell's first node: whether all corners have one label, and whether one is at risk.
  std::array<bool, nodes_of_block> uniform, at_risk;
  for (std::size_t n = 0; n < nodes_of_block; ++n) {
    uniform[n] = true;
    at_risk[n] = nodes[n].at_risk();
  }
  for (const std::size_t next : {node_number(1, 0, 0), node_number(0, 1, 0), node_number(0, 0, 1)})
    for (std::size_t n = 0; n + next < nodes_of_block; ++n) {
      uniform[n] = uniform[n] && uniform[n + next] && nodes[n].own() == nodes[n + next].own();
      at_risk[n] = at_risk[n] || at_risk[n + next];
    }
  for_each_of_cube(block_cells, [&](int x, int y, int z) {
    const std::size_t node = node_number(x, y, z);
    const unsigned cell = cell_number({x, y, z});
    block.parted |= CellSet{!uniform[node]} << cell;
    block.at_risk |= CellSet{at_risk[node]} << cell;
  });
}

}  // namespace

/// The fields of a whole tile, and what its blocks take from them.
class TileMaker::Fields {
 public:
  explicit Fields(const Rules& rules) : rules_(rules) {
    for (std::size_t a = 0; a < 3; ++a)
      narrow_taps_[a] = narrower(rules.taps[a], thin_taps());
  }

  /// Of the tile in the middle of a window.
  void compute(const LabelWindow& window) {
    window_ = &window;
    block_rank_.resize(window.materials.size());
    wide_.compute(window, rules_.taps);
    const auto whole = whole_blocks(window);
    find_at_risk(window, whole, at_risk_);
    find_slender(window, whole, slender_);
    if (!rules_.hold_slender) slender_.fill(Slender::no);
    some_thin_ = rules_.narrow_thin && find_thin(window, whole, thin_);
    if (some_thin_) narrow_.compute(window, narrow_taps_);
  }

  /// Appends a block to a tile; `corner` is its first node.
  void add_block(const std::array<int, 3>& corner, Block& block, Tile& tile) {
    block.first = static_cast<std::uint32_t>(tile.materials.size());
    for (std::size_t rank = 0; rank < window_->materials.size(); ++rank) {
      if (!gather(rank, corner)) continue;
      block_rank_[rank] = block.labels++;
      tile.materials.push_back(window_->materials[rank]);
      tile.values.insert(tile.values.end(), gathered_.begin(), gathered_.end());
    }
    if (block.labels == 1) {
      block = {.only = tile.materials.back()};
      tile.materials.pop_back();
      tile.values.resize(tile.values.size() - nodes_of_block);
      return;
    }
    block.nodes = static_cast<std::uint16_t>(tile.nodes.size() / nodes_of_block);
    add_nodes(corner, block, tile);
    find_cells(&tile.nodes[nodes_of_block * block.nodes], block);
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

  void add_nodes(const std::array<int, 3>& corner, const Block& block, Tile& tile) const {
    const std::int16_t* values = &tile.values[nodes_of_block * block.first];
    std::size_t n = 0;
    for (int z = corner[2]; z < corner[2] + block_nodes; ++z)
      for (int y = corner[1]; y < corner[1] + block_nodes; ++y)
        for (int x = corner[0]; x < corner[0] + block_nodes; ++x, ++n) {
          const int halo = window_->halo;
          const unsigned own =
              block_rank_[window_->ranks[window_->at(x + halo, y + halo, z + halo)]];
          unsigned bits = own;
          if (some_thin_ && thin_[tile_node_number(x, y, z)]) bits |= Node::thin_bit;
          if (at_risk_[tile_node_number(x, y, z)]) bits |= Node::at_risk_bit;
          tile.nodes.push_back({static_cast<std::uint16_t>(bits),
                                lead_bits_of(x, y, z, values[own * nodes_of_block + n])});
        }
  }

  /// `own` is the value of the node's own label.
  [[nodiscard]] std::uint16_t lead_bits_of(int x, int y, int z, std::int32_t own) const {
    const std::size_t node = tile_node_number(x, y, z);
    std::int32_t lead = some_thin_ && thin_[node] ? thin_lead : least_lead;
    // A voxel that shares is meant to have the surface nearer to its centre.
    if (slender_[node] != Slender::no && !shares(x, y, z)) lead = std::max(lead, row_lead(own));
    if (slender_[node] == Slender::part) lead = std::max(lead, part_lead(own));
    if (slender_[node] == Slender::thin_part) lead = std::max(lead, thin_part_lead(own));
    const bool firm = slender_[node] == Slender::thin_part;
    return static_cast<std::uint16_t>(lead | (firm ? Node::firm_bit : 0));
  }

  [[nodiscard]] bool shares(int x, int y, int z) const {
    const auto& parts = window_->parts;
    const int halo = window_->halo;
    return !parts.empty() && parts[window_->at(x + halo, y + halo, z + halo)] != 0;
  }

  const Rules& rules_;
  std::array<Taps, 3> narrow_taps_;
  const LabelWindow* window_ = nullptr;
  SmoothedLabels wide_, narrow_;
  bool some_thin_ = false;
  NodeFlags thin_{}, at_risk_{};
  Slenderness slender_{};
  std::array<std::int16_t, nodes_of_block> gathered_{};
  std::vector<std::uint16_t> block_rank_;  ///< of the window's materials
};

int halo_of(const Rules& rules) {
  int halo = 2;  // what is thin depends on so many
  for (const Taps& taps : rules.taps) halo = std::max(halo, taps.radius());
  return halo;
}

TileMaker::TileMaker(const Rules& rules) : fields_(std::make_unique<Fields>(rules)) {}
TileMaker::~TileMaker() = default;

std::unique_ptr<Tile> TileMaker::make(const LabelWindow& window) {
  if (window.materials.size() == 1) return nullptr;
  tile_.materials.clear();
  tile_.values.clear();
  tile_.nodes.clear();
  fields_->compute(window);
  for_each_of_cube(tile_blocks, [&](int x, int y, int z) {
    Block& block = tile_.blocks[block_number(x, y, z)] = {};
    fields_->add_block({block_cells * x, block_cells * y, block_cells * z}, block, tile_);
  });
  return std::make_unique<Tile>(tile_);  // which takes no more than it needs
}

}  // namespace certet::fields
