#include "region_volumes.hpp"

#include <algorithm>
#include <mutex>

#include "fields/for_each_tile.hpp"

namespace certet::fields {
namespace {

constexpr int points_per_axis = 4;

/// Places of points along one axis of a block, in 2^20ths of a voxel.
struct Places {
  Places(std::int64_t first_cell, std::int64_t voxels) {
    constexpr std::int64_t half = point_one / 2;
    const std::int64_t end = voxels * point_one + half;
    for (std::int64_t i = 0; i < block_cells * points_per_axis; ++i) {
      const std::int64_t at = first_cell * point_one + (2 * i + 1) * (half / points_per_axis);
      if (at > half && at < end) places[static_cast<std::size_t>(count++)] = at;
    }
  }
  std::array<std::int64_t, block_cells * points_per_axis> places{};
  std::int64_t count = 0;
};

class TileCounts {
 public:
  TileCounts(const Labelling& labelling, const std::array<std::int64_t, 3>& size,
             std::vector<std::uint64_t>& counts)
      : labelling_(labelling), size_(size), counts_(counts) {}

  void add_block(const BlockView& block, const std::array<std::int64_t, 3>& first_cell) {
    const Places x(first_cell[0], size_[0]), y(first_cell[1], size_[1]), z(first_cell[2], size_[2]);
    if (block.labels == 0) {
      counts_[static_cast<std::size_t>(block.only)] +=
          static_cast<std::uint64_t>(x.count * y.count * z.count);
      return;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(z.count); ++k)
      for (std::size_t j = 0; j < static_cast<std::size_t>(y.count); ++j)
        for (std::size_t i = 0; i < static_cast<std::size_t>(x.count); ++i) {
          const FieldPoint point{{x.places[i], y.places[j], z.places[k]}};
          ++counts_[static_cast<std::size_t>(labelling_.in_block(block, point.cell(), point))];
        }
  }

 private:
  const Labelling& labelling_;
  const std::array<std::int64_t, 3>& size_;
  std::vector<std::uint64_t>& counts_;
};

}  // namespace

std::vector<std::uint64_t> region_volumes(const NodeFields& fields, const Labelling& labelling,
                                          const std::array<std::int64_t, 3>& size,
                                          const Context& context) {
  std::vector<std::uint64_t> sums(fields.constants().size(), 0);
  std::mutex mutex;
  const auto& counts = fields.tile_counts();
  for_each_tile(context, static_cast<std::size_t>(counts[0] * counts[1] * counts[2]),
                [&](std::size_t t) {
    std::vector<std::uint64_t> of_tile(sums.size(), 0);
    TileCounts tile(labelling, size, of_tile);
    const std::array<std::int64_t, 3> first = fields.first_cell(t);
    for (std::int64_t z = first[2]; z < first[2] + tile_cells; z += block_cells)
      for (std::int64_t y = first[1]; y < first[1] + tile_cells; y += block_cells)
        for (std::int64_t x = first[0]; x < first[0] + tile_cells; x += block_cells)
          tile.add_block(fields.block({x, y, z}), {x, y, z});
    const std::lock_guard lock(mutex);
    std::ranges::transform(sums, of_tile, sums.begin(), std::plus<>());
  });
  return sums;
}

}  // namespace certet::fields
