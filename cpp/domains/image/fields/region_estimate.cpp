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
  void find_ahead(Eight& ahead) const { ahead = (first_ >> bits) - (second_ >> bits); }

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

constexpr int lower_bits = 9;

/// All bits of those that are among the points.
void choose(PointSet points, Eight& all_bits) {
  constexpr Eight bit{1, 2, 4, 8, 16, 32, 64, 128};
  all_bits = (bit & static_cast<std::int32_t>(points)) != 0;
}

std::int32_t sum_of(const Eight& eight) {
  Eight values = eight;
  values += __builtin_shufflevector(values, values, 4, 5, 6, 7, 0, 1, 2, 3);
  values += __builtin_shufflevector(values, values, 2, 3, 0, 1, 6, 7, 4, 5);
  return values[0] + values[1];
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

/// The slope is taken in two parts, so that 32 bits hold all products.
Ramp::Ramp(std::int32_t slope)
    : upper_(slope >> lower_bits),
      lower_(slope & ((1 << lower_bits) - 1)),
      settled_(static_cast<std::int32_t>(((settled << (16 + 6)) + slope - 1) / slope)),
      area_((2 * std::int64_t{field_one} * slope) >> 16),
      settled_margin_(static_cast<std::int16_t>(((settled << 16) + slope - 1) / slope)) {}

void Ramp::find_parts(const Eight& ahead, Eight& parts) const {
  const Eight bounded = ahead < settled_ ? ahead : Eight{} + settled_;
  const Eight inside =
      (bounded * upper_ + (bounded * lower_ >> lower_bits)) >> (16 + 6 - lower_bits);
  parts = ahead < settled_ ? field_one / 2 + 2 * inside : Eight{} + field_one;
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
    const Ramp& ramp = some_thin && is_thin(block, node) ? narrow_ : wide_;
    if (least[node] < ramp.settled_margin()) return add_cell(block, node, points, ramp);
    const auto own = static_cast<std::size_t>(held_.own[node]);
    if (own != settled_label) add_settled();
    settled_label = own;
    settled_points += count_of(points);
  });
  add_settled();
}

void TileEstimate::add_cell(const BlockView& block, std::size_t node, PointSet points,
                            const Ramp& ramp) {
  near_.resize(std::max(near_.size(), block.labels));
  near_materials_.resize(near_.size());
  std::size_t count = 0, near = 0, far = 0, first = 0, second = 0;
  bool behind = false;  // a field is that of a label which is not near
  for (std::size_t l = 0; l < block.labels; ++l) {
    const CornerPairs corners = corner_pairs(&held_.values[l * nodes_of_block + node]);
    const std::uint32_t bits = bits_of(corners);
    // Only two of those that are 0 can be ahead of others.
    if (bits == 0 && ++far > 2) continue;
    behind = behind || (bits & sign_bits) != 0;
    if (bits != 0 && ++near <= 2) (near == 1 ? first : second) = count;
    if (count == static_cast<std::size_t>(Winners::most_labels)) continue;
    near_materials_[count] = block.materials[l];
    to_quarters(corners, near_[count++]);
  }
  near_count_ = count;
  if (near != 2 || (behind && far != 0)) add_several(points, ramp);
  else add_two(first, second, points, ramp);
}

/// Of equal fields it is the first.
void TileEstimate::add_two(std::size_t first, std::size_t second, PointSet points,
                           const Ramp& ramp) {
  const Eight ahead = near_[first] - near_[second];
  Eight parts, within;
  ramp.find_parts(ahead < 0 ? -ahead : ahead, parts);
  choose(points, within);
  const std::int32_t of_first = sum_of((ahead >= 0 ? parts : field_one - parts) & within);
  const std::int64_t unsettled = -sum_of((parts < field_one) & within);
  const Material one = near_materials_[first], other = near_materials_[second];
  sums_.add_volume(one, of_first);
  sums_.add_volume(other, field_one * count_of(points) - of_first);
  if (unsettled != 0) sums_.add_area(one, other, unsettled * ramp.area());
}

void TileEstimate::add_several(PointSet points, const Ramp& ramp) {
  Winners winners;
  for (std::size_t i = 0; i < near_count_; ++i)
    winners.add(near_[i], static_cast<std::int32_t>(i));
  Eight ahead, parts;
  winners.find_ahead(ahead);
  ramp.find_parts(ahead, parts);
  for (std::size_t p = 0; p < 8; ++p) {
    if ((points >> p & 1) == 0) continue;
    const Material first = near_materials_[winners.first(p)];
    sums_.add_volume(first, parts[p]);
    if (parts[p] == field_one) continue;
    const Material second = near_materials_[winners.second(p)];
    sums_.add_volume(second, field_one - parts[p]);
    sums_.add_area(first, second, ramp.area());
  }
}

}  // namespace certet::fields
