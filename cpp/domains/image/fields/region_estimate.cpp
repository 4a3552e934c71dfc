#include "region_estimate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fields/cell_points.hpp"

namespace certet::fields {
namespace {

std::int64_t count_of(PointSet points) { return std::popcount(points); }

/// Of all corners together.
std::uint32_t bits_of(const CornerPairs& corners) {
  return static_cast<std::uint32_t>(corners[0] | corners[1] | corners[2] | corners[3]);
}
constexpr std::uint32_t sign_bits = 0x80008000;

/// A field at the eight points, 64 times as great.
void to_quarters(const CornerPairs& corners, Eight& field) {
  spread(corners, field);
  field = 3 * field + __builtin_shufflevector(field, field, 1, 0, 3, 2, 5, 4, 7, 6);
  field = 3 * field + __builtin_shufflevector(field, field, 2, 3, 0, 1, 6, 7, 4, 5);
  field = 3 * field + __builtin_shufflevector(field, field, 4, 5, 6, 7, 0, 1, 2, 3);
}

/// The greatest fields of the eight points and the second ones: values and, in the lowest bits,
/// the lower the label the more.
class Winners {
 public:
  /// What more labels there are near one cell, all but nothing of it is theirs.
  static constexpr std::int32_t most_labels = 1024;

  Winners() {
    for (std::size_t p = 0; p < 8; ++p) first_[p] = std::numeric_limits<std::int32_t>::min();
    second_ = first_;
  }

  void add(const Eight& field, std::int32_t number) {
    const Eight key = field * most_labels + (most_labels - 1 - number);
    const Eight lower = key < first_ ? key : first_;
    second_ = lower > second_ ? lower : second_;
    first_ = key > first_ ? key : first_;
  }

  [[nodiscard]] std::size_t first(std::size_t point) const { return number(first_[point]); }
  [[nodiscard]] std::size_t second(std::size_t point) const { return number(second_[point]); }
  [[nodiscard]] std::int64_t ahead(std::size_t point) const {
    return std::int64_t{first_[point] >> bits} - (second_[point] >> bits);
  }

 private:
  static constexpr int bits = std::countr_zero(std::uint32_t{most_labels});
  static std::size_t number(std::int32_t key) {
    return static_cast<std::size_t>(most_labels - 1 - (key & (most_labels - 1)));
  }

  Eight first_, second_;
};

/// How far the surface is inside of which all of a point's eighth of a voxel lies: half
/// its width, in 16384ths of a voxel.
constexpr std::int64_t settled = field_one / 4;

/// The least margin that is as much.
std::int16_t settled_margin(std::int64_t slope) {
  return static_cast<std::int16_t>(((settled << 16) + slope - 1) / slope);
}

/// The least margin of the corners of each cell, at its first node: between them no margin is
/// less.  0 where they have different labels.
OfNodes least_margins(const HeldBlock& held) {
  OfNodes least = held.margins;
  for (const std::size_t next : {node_number(1, 0, 0), node_number(0, 1, 0), node_number(0, 0, 1)})
    for (std::size_t n = 0; n + next < nodes_of_block; ++n) {
      const std::int16_t both = std::min(least[n], least[n + next]);
      least[n] = held.own[n] == held.own[n + next] ? both : std::int16_t{0};
    }
  return least;
}

bool is_thin(const BlockView& block, std::size_t node) {
  return std::ranges::any_of(
      cell_corners, [&](std::size_t corner) { return block.nodes[node + corner].thin(); });
}

bool is_thin(const BlockView& block) {
  unsigned bits = 0;
  for (std::size_t n = 0; n < nodes_of_block; ++n) bits |= block.nodes[n].bits;
  return (bits & Node::thin_bit) != 0;
}

/// Whether all cells of a block lie within an image with all their points.
bool is_within(const Cell& first, const std::array<std::int64_t, 3>& size) {
  bool within = true;
  for (std::size_t a = 0; a < 3; ++a)
    within = within && first[a] > 0 && first[a] + block_cells <= size[a];
  return within;
}

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
  raise_and_hold(block, constants, hold, held_);
  const OfNodes least = least_margins(held_);
  const bool within = is_within(first_cell, size_), some_thin = is_thin(block);
  const std::int16_t wide = settled_margin(slopes_.wide), narrow = settled_margin(slopes_.narrow);
  // Of settled cells one after the other; mostly they have one label.
  std::size_t settled_label = 0;
  std::int64_t settled_points = 0;
  const auto add_settled = [&] {
    sums_.add_volume(block.materials[settled_label], field_one * settled_points);
    settled_points = 0;
  };
  for_each_of_cube(block_cells, [&](int x, int y, int z) {
    const std::size_t node = node_number(x, y, z);
    const PointSet points =
        within ? 0xff
               : points_within<2>({first_cell[0] + x, first_cell[1] + y, first_cell[2] + z}, size_);
    const bool thin = some_thin && is_thin(block, node);
    if (least[node] < (thin ? narrow : wide))
      return add_cell(block, node, points, thin ? slopes_.narrow : slopes_.wide);
    const auto own = static_cast<std::size_t>(held_.own[node]);
    if (own != settled_label) add_settled();
    settled_label = own;
    settled_points += count_of(points);
  });
  add_settled();
}

/// What regions of two labels have of some points.
class TileEstimate::Parts {
 public:
  Parts(Material first, Material second, std::int64_t slope)
      : first_(first), second_(second), slope_(slope) {}

  /// A point that is x voxels inside gives a part of min(1, 1/2 + 2x) to the label with the
  /// greatest field, and the rest to the second.  `ahead` is 64 times by how much the first
  /// one's is greater; of equal ones it is the first.
  void add(std::int64_t ahead) {
    const std::int64_t inside = (std::abs(ahead) * slope_) >> (16 + 6);
    const bool is_settled = inside >= settled;
    const std::int64_t part = is_settled ? field_one : field_one / 2 + 2 * inside;
    of_first_ += ahead >= 0 ? part : field_one - part;
    of_second_ += ahead >= 0 ? field_one - part : part;
    unsettled_ += is_settled ? 0 : 1;
  }

  void add_to(RegionSums& sums) const {
    sums.add_volume(first_, of_first_);
    sums.add_volume(second_, of_second_);
    if (unsettled_ != 0)
      sums.add_area(first_, second_, unsettled_ * ((2 * field_one * slope_) >> 16));
  }

  [[nodiscard]] bool are_of(Material first, Material second) const {
    return first == first_ && second == second_;
  }

 private:
  Material first_, second_;
  std::int64_t slope_, of_first_ = 0, of_second_ = 0, unsettled_ = 0;
};

void TileEstimate::add_cell(const BlockView& block, std::size_t node, PointSet points,
                            std::int64_t slope) {
  std::size_t near = 0, far = 0;
  bool behind = false;  // a field is that of a label which is not near
  near_.clear();
  for (std::size_t l = 0; l < block.labels; ++l) {
    const CornerPairs corners = corner_pairs(&held_.values[l * nodes_of_block + node]);
    const std::uint32_t bits = bits_of(corners);
    // Only two of those that are 0 can be ahead of others.
    if (bits == 0 && ++far > 2) continue;
    near += bits != 0 ? 1 : 0;
    behind = behind || (bits & sign_bits) != 0;
    if (near_.size() == static_cast<std::size_t>(Winners::most_labels)) continue;
    near_.push_back({Eight{}, block.materials[l], bits != 0});
    to_quarters(corners, near_.back().values);
  }
  if (near != 2 || (behind && far != 0)) return add_several(points, slope);
  const auto is_near = [](const Field& field) { return field.is_near; };
  const auto first = std::ranges::find_if(near_, is_near);
  const auto second = std::ranges::find_if(first + 1, near_.end(), is_near);
  add_two(*first, *second, points, slope);
}

void TileEstimate::add_two(const Field& first, const Field& second, PointSet points,
                           std::int64_t slope) {
  const Eight ahead = first.values - second.values;
  Parts parts(first.of, second.of, slope);
  for (std::size_t p = 0; p < 8; ++p)
    if ((points >> p & 1) != 0) parts.add(ahead[p]);
  parts.add_to(sums_);
}

void TileEstimate::add_several(PointSet points, std::int64_t slope) {
  Winners winners;
  for (std::size_t i = 0; i < near_.size(); ++i)
    winners.add(near_[i].values, static_cast<std::int32_t>(i));
  Parts parts(near_[0].of, near_[1].of, slope);
  for (std::size_t p = 0; p < 8; ++p) {
    if ((points >> p & 1) == 0) continue;
    const Material first = near_[winners.first(p)].of, second = near_[winners.second(p)].of;
    if (!parts.are_of(first, second)) {
      parts.add_to(sums_);
      parts = Parts(first, second, slope);
    }
    parts.add(winners.ahead(p));
  }
  parts.add_to(sums_);
}

}  // namespace certet::fields
