#include "region_estimate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "fields/cell_corners.hpp"
#include "fields/cell_points.hpp"

namespace certet::fields {
namespace {

std::int64_t count_of(PointSet points) { return std::popcount(points); }

/// A field at the eight points of a cell, 64 times as great.
using Quarters = std::array<std::int32_t, 8>;

Quarters at_quarters(const std::int32_t* first_node) {
  Quarters values;
  for (std::size_t c = 0; c < 8; ++c) values[c] = first_node[cell_corners[c]];
  for (std::size_t axis = 1; axis < 8; axis *= 2) {
    Quarters mixed;
    for (std::size_t p = 0; p < 8; ++p) mixed[p] = 3 * values[p] + values[p ^ axis];
    values = mixed;
  }
  return values;
}

/// The greatest fields of the eight points and the second ones.
struct Winners {
  Quarters first, second, of_first, of_second;

  Winners() {
    first.fill(std::numeric_limits<std::int32_t>::min() / 2);
    second = first;
    of_first.fill(0);
    of_second.fill(0);
  }

  void add(const Quarters& values, std::int32_t label) {
    for (std::size_t p = 0; p < 8; ++p) {
      const bool wins = values[p] > first[p], is_second = values[p] > second[p];
      of_second[p] = wins ? of_first[p] : is_second ? label : of_second[p];
      second[p] = wins ? first[p] : is_second ? values[p] : second[p];
      of_first[p] = wins ? label : of_first[p];
      first[p] = wins ? values[p] : first[p];
    }
  }
};

/// How far the surface is inside of which all of a point's eighth of a voxel lies: half
/// its width, in 16384ths of a voxel.
constexpr std::int64_t settled = field_one / 4;

}  // namespace

std::int32_t slope_of(double deviation) {
  return static_cast<std::int32_t>(std::lround(65536 * 1.25 * deviation));
}

void TileEstimate::add_uniform(Material material, const Cell& first_cell,
                               int cells) {
  std::int64_t points = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    std::int64_t along = 0;
    for (std::int64_t cell = first_cell[a]; cell < first_cell[a] + cells; ++cell)
      along += count_of(points_along<2>(cell, size_[a]));
    points *= along;
  }
  sums_.add_volume(material, field_one * points);
}

void TileEstimate::add_block(const BlockView& block,
                             const Cell& first_cell,
                             const Constants& constants, bool hold) {
  if (block.labels == 0) return add_uniform(block.only, first_cell, block_cells);
  values_.resize(block.labels * nodes_of_block);
  raise_and_hold(block, constants, hold, values_);
  find_margins(block);
  for_each_of_cube(block_cells, [&](int x, int y, int z) {
    const std::size_t node = node_number(x, y, z);
    const PointSet points =
        points_within<2>({first_cell[0] + x, first_cell[1] + y, first_cell[2] + z}, size_);
    if (is_settled(block, node)) {
      const Material own = block.materials[block.nodes[node].own()];
      sums_.add_volume(own, field_one * count_of(points));
    } else {
      add_cell(block, node, points);
    }
  });
}

void TileEstimate::find_margins(const BlockView& block) {
  margins_.fill(0);
  const std::int32_t* value = values_.data();
  for (std::size_t l = 0; l < block.labels; ++l, value += nodes_of_block)
    for (std::size_t n = 0; n < nodes_of_block; ++n)
      margins_[n] = std::max(margins_[n], block.nodes[n].own() == l ? 0 : value[n]);
  for (std::size_t n = 0; n < nodes_of_block; ++n)
    margins_[n] = values_[block.nodes[n].own() * nodes_of_block + n] - margins_[n];
}

/// Whether no surface is near, as the corners' margins tell: between them no margin is
/// less.
bool TileEstimate::is_settled(const BlockView& block, std::size_t node) const {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  bool thin = false;
  for (const std::size_t corner : cell_corners) {
    const Node& other = block.nodes[node + corner];
    if (other.own() != block.nodes[node].own()) return false;
    thin = thin || other.thin();
    least = std::min<std::int64_t>(least, margins_[node + corner]);
  }
  return ((least * (thin ? slopes_.narrow : slopes_.wide)) >> 16) >= settled;
}

/// A point that is x voxels inside gives a part of min(1, 1/2 + 2x) to the label with the
/// greatest field, and the rest to the second.
void TileEstimate::add_cell(const BlockView& block, std::size_t node, PointSet points) {
  Winners winners;
  for (std::size_t l = 0; l < block.labels; ++l)
    winners.add(at_quarters(&values_[l * nodes_of_block + node]), static_cast<std::int32_t>(l));
  const bool thin = std::ranges::any_of(
      cell_corners, [&](std::size_t corner) { return block.nodes[node + corner].thin(); });
  const std::int64_t slope = thin ? slopes_.narrow : slopes_.wide;
  const std::int64_t growth = (2 * field_one * slope) >> 16;
  const auto material = [&](std::int32_t label) {
    return block.materials[static_cast<std::size_t>(label)];
  };
  for (std::size_t p = 0; p < 8; ++p) {
    if ((points >> p & 1) == 0) continue;
    const Material first = material(winners.of_first[p]);
    const std::int64_t inside =
        ((std::int64_t{winners.first[p]} - winners.second[p]) * slope) >> (16 + 6);
    if (inside >= settled) {
      sums_.add_volume(first, field_one);
      continue;
    }
    const Material second = material(winners.of_second[p]);
    const std::int64_t part = field_one / 2 + 2 * inside;
    sums_.add_volume(first, part);
    sums_.add_volume(second, field_one - part);
    sums_.add_area(first, second, growth);
  }
}

}  // namespace certet::fields
