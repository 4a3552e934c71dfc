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
      tile.values.insert(tile.values.end(), gathered_.begin(), gathered_.begin() + nodes_of_block);
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
    using Five [[gnu::vector_size(16)]] = std::uint16_t;  // and three that are written over
    constexpr auto all = static_cast<std::uint16_t>(-1);
    constexpr Five five{all, all, all, all, all, 0, 0, 0};
    Five some{};
    std::int16_t* out = gathered_.data();
    for (int z = corner[2]; z < corner[2] + block_nodes; ++z)
      for (int y = corner[1]; y < corner[1] + block_nodes; ++y, out += block_nodes) {
        Five values{};
        if (const std::uint16_t* wide = wide_.row(rank, y, z); wide != nullptr)
          std::memcpy(&values, wide + corner[0], sizeof(values));
        if (some_thin_) narrow(rank, {corner[0], y, z}, values);
        std::memcpy(out, &values, sizeof(values));
        some |= values & five;
      }
    std::array<std::uint64_t, 2> words;
    std::memcpy(&words, &some, sizeof(some));
    return (words[0] | words[1]) != 0;
  }

  /// Where a label has no wide row it has no narrow one.
  template <class Five>
  void narrow(std::size_t rank, const std::array<int, 3>& first, Five& values) const {
    const bool* thin = &thin_[tile_node_number(first[0], first[1], first[2])];
    if (!(thin[0] || thin[1] || thin[2] || thin[3] || thin[4])) return;
    const std::uint16_t* row = narrow_.row(rank, first[1], first[2]);
    for (std::size_t x = 0; x < block_nodes; ++x)
      if (thin[x]) values[x] = row == nullptr ? 0 : row[first[0] + static_cast<int>(x)];
  }

  void add_nodes(const std::array<int, 3>& corner, const Block& block, Tile& tile) const {
    const std::int16_t* values = &tile.values[nodes_of_block * block.first];
    const std::size_t first = tile.nodes.size();
    tile.nodes.resize(first + nodes_of_block);
    Node* node = &tile.nodes[first];
    const int halo = window_->halo;
    for (int z = corner[2]; z < corner[2] + block_nodes; ++z)
      for (int y = corner[1]; y < corner[1] + block_nodes; ++y) {
        const std::size_t in_window = window_->at(corner[0] + halo, y + halo, z + halo);
        const std::size_t in_tile = tile_node_number(corner[0], y, z);
        for (std::size_t x = 0; x < block_nodes; ++x, ++node, ++values) {
          const unsigned own = block_rank_[window_->ranks[in_window + x]];
          const bool thin = some_thin_ && thin_[in_tile + x];
          node->bits = static_cast<std::uint16_t>(own | (thin ? Node::thin_bit : 0) |
                                                  (at_risk_[in_tile + x] ? Node::at_risk_bit : 0));
          node->lead_bits = static_cast<std::uint16_t>(thin ? thin_lead : least_lead);
          if (slender_[in_tile + x] != Slender::no)
            node->lead_bits = lead_bits_of(slender_[in_tile + x], in_window + x, node->lead(),
                                           values[own * nodes_of_block]);
        }
      }
  }

  /// Of a slender voxel with that lead at least; `own` is the value of its own label.
  [[nodiscard]] std::uint16_t lead_bits_of(Slender slender, std::size_t in_window,
                                           std::int32_t lead, std::int32_t own) const {
    // A voxel that shares is meant to have the surface nearer to its centre.
    if (!shares(in_window)) lead = std::max(lead, row_lead(own));
    if (slender == Slender::part) lead = std::max(lead, part_lead(own));
    if (slender == Slender::thin_part) lead = std::max(lead, thin_part_lead(own));
    const bool firm = slender == Slender::thin_part;
    return static_cast<std::uint16_t>(lead | (firm ? Node::firm_bit : 0));
  }

  [[nodiscard]] bool shares(std::size_t in_window) const {
    return !window_->parts.empty() && window_->parts[in_window] != 0;
  }

  const Rules& rules_;
  std::array<Taps, 3> narrow_taps_;
  const LabelWindow* window_ = nullptr;
  SmoothedLabels wide_, narrow_;
  bool some_thin_ = false;
  NodeFlags thin_{}, at_risk_{};
  Slenderness slender_{};
  std::array<std::int16_t, nodes_of_block + 3> gathered_{};
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
