#include "region_volumes.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <mutex>

#include "fields/cell_points.hpp"
#include "fields/field_cell.hpp"
#include "fields/for_each_tile.hpp"

namespace certet::fields {
namespace {

constexpr std::size_t points_per_cell = 64;

/// A value for each point of a cell, the first axis running fastest.
using Points = std::array<std::int32_t, points_per_cell>;

/// 512 times a field.
Points at_points(const Corners& corner) {
  std::array<std::int32_t, 16> along_x;
  std::array<std::int32_t, 32> along_y;
  Points points;
  const auto mixed = [](std::int32_t low, std::int32_t high, std::size_t i) {
    return static_cast<std::int32_t>(7 - 2 * i) * low + static_cast<std::int32_t>(1 + 2 * i) * high;
  };
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < 4; ++i)
      along_x[4 * c + i] = mixed(corner[2 * c], corner[2 * c + 1], i);
  for (std::size_t z = 0; z < 2; ++z)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i)
        along_y[16 * z + 4 * j + i] = mixed(along_x[8 * z + i], along_x[8 * z + 4 + i], j);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 16; ++i) points[16 * k + i] = mixed(along_y[i], along_y[16 + i], k);
  return points;
}

/// The corner that a point is nearest to.
constexpr std::size_t corner_of(std::size_t point) {
  return (point >> 1 & 1) | (point >> 3 & 1) << 1 | (point >> 5 & 1) << 2;
}

/// Counts points, as `Labelling` labels them.
class CellCounts {
 public:
  CellCounts(const std::array<std::int64_t, 3>& size, bool force,
             std::vector<std::uint64_t>& counts)
      : size_(size), force_(force), counts_(counts) {}

  void add_block(const BlockView& block, const Cell& first) {
    for_each_of_cube(block_cells, [&](int x, int y, int z) {
      const Cell cell{first[0] + x, first[1] + y, first[2] + z};
      const PointSet points = points_within<4>(cell, size_);
      if (block.labels == 0) add(block.only, static_cast<std::uint64_t>(std::popcount(points)));
      else add_cell(FieldCell(block, cell), points);
    });
  }

 private:
  void add(Material material, std::uint64_t points) {
    counts_[static_cast<std::size_t>(material)] += points;
  }

  void add_cell(const FieldCell& cell, PointSet points) {
    std::array<std::size_t, 8> labels;
    bool forced = false;
    for (std::size_t c = 0; c < 8; ++c) {
      labels[c] = cell.node(c).own();
      forced = forced || (force_ && cell.node(c).at_risk());
    }
    std::ranges::sort(labels);
    if (labels[0] == labels[7])
      return add(cell.material(labels[0]), static_cast<std::uint64_t>(std::popcount(points)));
    Points best;
    best.fill(std::numeric_limits<std::int32_t>::min());
    std::array<std::size_t, points_per_cell> of_best{};
    const auto end = std::unique(labels.begin(), labels.end());
    for (auto label = labels.begin(); label != end; ++label) {
      const Points values = at_points(cell.values(*label));
      for (std::size_t p = 0; p < points_per_cell; ++p) {
        of_best[p] = values[p] > best[p] ? *label : of_best[p];
        best[p] = std::max(best[p], values[p]);
      }
    }
    for (std::size_t p = 0; p < points_per_cell; ++p) {
      if ((points >> p & 1) == 0) continue;
      const Node& nearest = cell.node(corner_of(p));
      add(cell.material(forced && nearest.at_risk() ? nearest.own() : of_best[p]), 1);
    }
  }

  const std::array<std::int64_t, 3>& size_;
  bool force_;
  std::vector<std::uint64_t>& counts_;
};

}  // namespace

std::vector<std::uint64_t> region_volumes(const NodeFields& fields,
                                          const std::array<std::int64_t, 3>& size, bool force,
                                          const Context& context) {
  std::vector<std::uint64_t> sums(fields.constants().size(), 0);
  std::mutex mutex;
  for_each_tile(context, fields.tile_count(), [&](std::size_t t) {
    std::vector<std::uint64_t> of_tile(sums.size(), 0);
    CellCounts cells(size, force, of_tile);
    fields.for_each_block(t, [&](const BlockView& block, const Cell& first) {
      cells.add_block(block, first);
    });
    const std::lock_guard lock(mutex);
    std::ranges::transform(sums, of_tile, sums.begin(), std::plus<>());
  });
  return sums;
}

}  // namespace certet::fields
