#include "region_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace certet::fields {
namespace {

constexpr std::int64_t weight_of_node = 64;
constexpr std::int64_t weight_of_cell = 128;

/// How much of a row of nodes or cells belongs to the image, where 2 is all of one.
/// Nodes 1 to n are voxels; of cells 0 and n a half lies beyond the image.
std::int64_t part_of_node(std::int64_t node, std::int64_t voxels) {
  return node >= 1 && node <= voxels ? 2 : 0;
}
std::int64_t part_of_cell(std::int64_t cell, std::int64_t voxels) {
  return cell > voxels ? 0 : cell == 0 || cell == voxels ? 1 : 2;
}

/// The greatest field of a point and the second.
struct Winners {
  std::int32_t first = std::numeric_limits<std::int32_t>::min() / 2;
  std::int32_t second = first;
  std::size_t of_first = 0, of_second = 0;
  void add(std::int32_t value, std::size_t label) {
    if (value > first) {
      second = first;
      of_second = of_first;
      first = value;
      of_first = label;
    } else if (value > second) {
      second = value;
      of_second = label;
    }
  }
};

}  // namespace

RegionSums& RegionSums::operator+=(const RegionSums& other) {
  std::ranges::transform(volume, other.volume, volume.begin(), std::plus<>());
  std::ranges::transform(area, other.area, area.begin(), std::plus<>());
  return *this;
}

std::int64_t slope_of(double deviation) { return std::llround(65536 * 1.25 * deviation); }

/// The points of one block, whose fields are raised and held.
class TileEstimate::BlockEstimate {
 public:
  BlockEstimate(TileEstimate& tile, const BlockView& block,
                const std::array<std::int64_t, 3>& first_cell)
      : tile_(tile), block_(block), first_(first_cell) {}

  void add() {
    for (int z = 0; z < block_cells; ++z)
      for (int y = 0; y < block_cells; ++y)
        for (int x = 0; x < block_cells; ++x) {
          const std::array<int, 3> at{x, y, z};
          if (const std::int64_t part = part_of(part_of_node, at); part != 0)
            add_node(node_number(x, y, z), part);
          if (const std::int64_t part = part_of(part_of_cell, at); part != 0)
            add_cell(node_number(x, y, z), part);
        }
  }

 private:
  template <class PartAlong>
  [[nodiscard]] std::int64_t part_of(const PartAlong& along, const std::array<int, 3>& at) const {
    std::int64_t part = 1;
    for (std::size_t a = 0; a < 3; ++a) part *= along(first_[a] + at[a], tile_.size_[a]);
    return part;
  }

  /// `part` is in eighths.
  void add_node(std::size_t node, std::int64_t part) {
    Winners winners;
    for (std::size_t l = 0; l < block_.labels; ++l)
      winners.add(tile_.values_[l * nodes_of_block + node], l);
    add_point(winners, block_.nodes[node].thin(), Ramp::steep, weight_of_node / 8 * part);
  }

  void add_cell(std::size_t node, std::int64_t part) {
    if (is_uniform(node)) {
      add_volume(block_.nodes[node].own(), 3 * field_one, weight_of_cell / 8 * part);
      return;
    }
    if (is_near_thin(node)) return add_quarters(node, part);
    Winners winners;
    for (std::size_t l = 0; l < block_.labels; ++l) {
      std::int32_t sum = 0;
      for (const std::size_t corner : corners) sum += tile_.values_[l * nodes_of_block + node + corner];
      winners.add(sum >> 3, l);
    }
    add_point(winners, false, Ramp::steep, weight_of_cell / 8 * part);
  }

  /// Eight points, a quarter of the cell's width from its faces.
  void add_quarters(std::size_t node, std::int64_t part) {
    std::array<Winners, 8> winners;
    for (std::size_t l = 0; l < block_.labels; ++l) {
      const std::int32_t* value = &tile_.values_[l * nodes_of_block + node];
      for (std::size_t q = 0; q < 8; ++q) {
        std::int32_t sum = 0;
        for (std::size_t c = 0; c < 8; ++c) sum += quarter_weights[q ^ c] * value[corners[c]];
        winners[q].add(sum >> 6, l);
      }
    }
    for (const Winners& point : winners)
      add_point(point, true, Ramp::plain, weight_of_cell / 64 * part);
  }

  /// How much of the volume around a point that is x inside belongs to its region:
  ///     plain  min(1, 1/2 + 2x)
  ///     steep  (4 min(1, 1/2 + 2x) - (1/2 + x)) / 3 for x < 1/2, else 1
  /// A ramp 1/2 + x alone shrinks balls.
  enum class Ramp { plain, steep };

  void add_point(const Winners& winners, bool thin, Ramp ramp, std::int64_t weight) {
    const std::int64_t slope = thin ? tile_.slopes_.narrow : tile_.slopes_.wide;
    const std::int64_t inside = ((std::int64_t{winners.first} - winners.second) * slope) >> 16;
    constexpr std::int64_t half = field_one / 2;
    if (inside >= half) return add_volume(winners.of_first, 3 * field_one, weight);
    const std::int64_t twice = std::min<std::int64_t>(field_one, half + 2 * inside);
    const std::int64_t thirds = ramp == Ramp::plain ? 3 * twice : 4 * twice - (half + inside);
    add_volume(winners.of_first, thirds, weight);
    add_volume(winners.of_second, 3 * field_one - thirds, weight);
    // By 1 of the field the surface moves so many voxels.
    const std::int64_t area = ((3 * field_one * slope) >> 16) * weight;
    area_of(winners.of_first) += area;
    area_of(winners.of_second) += area;
  }

  void add_volume(std::size_t label, std::int64_t thirds, std::int64_t weight) {
    tile_.sums_.volume[static_cast<std::size_t>(block_.materials[label])] += thirds * weight;
  }
  std::int64_t& area_of(std::size_t label) {
    return tile_.sums_.area[static_cast<std::size_t>(block_.materials[label])];
  }

  /// Whether another label than its corners' can be among the first two at its centre,
  /// and near: not where all that a cell's corners and its neighbours have is one label.
  [[nodiscard]] bool is_uniform(std::size_t node) const {
    for (std::size_t l = 0; l < block_.labels; ++l) {
      if (l == block_.nodes[node].own()) continue;
      for (const std::size_t corner : corners)
        if (tile_.values_[l * nodes_of_block + node + corner] != 0) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_near_thin(std::size_t node) const {
    return std::ranges::any_of(
        corners, [&](std::size_t corner) { return block_.nodes[node + corner].thin(); });
  }

  static constexpr std::array<std::size_t, 8> corners{
      node_number(0, 0, 0), node_number(1, 0, 0), node_number(0, 1, 0), node_number(1, 1, 0),
      node_number(0, 0, 1), node_number(1, 0, 1), node_number(0, 1, 1), node_number(1, 1, 1)};
  /// In 64ths, by the axes along which a corner is the farther one.
  static constexpr std::array<std::int32_t, 8> quarter_weights{27, 9, 9, 3, 9, 3, 3, 1};

  TileEstimate& tile_;
  const BlockView& block_;
  const std::array<std::int64_t, 3>& first_;
};

void TileEstimate::add_uniform(Material material, const std::array<std::int64_t, 3>& first_cell,
                               int cells) {
  std::int64_t of_nodes = 1, of_cells = 1;  // in eighths
  for (std::size_t a = 0; a < 3; ++a) {
    std::int64_t nodes_along = 0, cells_along = 0;
    for (std::int64_t at = first_cell[a]; at < first_cell[a] + cells; ++at) {
      nodes_along += part_of_node(at, size_[a]);
      cells_along += part_of_cell(at, size_[a]);
    }
    of_nodes *= nodes_along;
    of_cells *= cells_along;
  }
  sums_.volume[static_cast<std::size_t>(material)] +=
      3 * field_one * (weight_of_node / 8 * of_nodes + weight_of_cell / 8 * of_cells);
}

void TileEstimate::add_block(const BlockView& block,
                             const std::array<std::int64_t, 3>& first_cell,
                             const Constants& constants, bool hold) {
  if (block.labels == 0) return add_uniform(block.only, first_cell, block_cells);
  values_.resize(block.labels * nodes_of_block);
  raise_and_hold(block, constants, hold, values_);
  BlockEstimate(*this, block, first_cell).add();
}

}  // namespace certet::fields
