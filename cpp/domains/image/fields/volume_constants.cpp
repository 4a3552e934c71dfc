#include "volume_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <span>

#include "fields/for_each_tile.hpp"
#include "fields/node_fields.hpp"
#include "fields/region_estimate.hpp"

namespace certet::fields {
namespace {

constexpr int passes = 5;
constexpr std::int32_t greatest_constant = 6554;  ///< 0.4
constexpr double moved_at_once = 0.9;

/// Of all tiles, merged in any order.
RegionSums estimate(const NodeFields& fields, const MaterialImage& image, const Slopes& slopes,
                    const Constants& constants, bool hold, const Context& context) {
  RegionSums sums(constants.size());
  std::mutex mutex;
  const auto& counts = fields.tile_counts();
  for_each_tile(context, static_cast<std::size_t>(counts[0] * counts[1] * counts[2]),
                [&](std::size_t t) {
    RegionSums of_tile(constants.size());
    TileEstimate estimate(image.size(), slopes, of_tile);
    const auto first = fields.first_cell(t);
    if (fields.tile(t) == nullptr) {
      estimate.add_uniform(fields.only(t), first, tile_cells);
    } else {
      for (std::int64_t z = first[2]; z < first[2] + tile_cells; z += block_cells)
        for (std::int64_t y = first[1]; y < first[1] + tile_cells; y += block_cells)
          for (std::int64_t x = first[0]; x < first[0] + tile_cells; x += block_cells)
            estimate.add_block(fields.block({x, y, z}), {x, y, z}, constants, hold);
    }
    const std::lock_guard lock(mutex);
    sums += of_tile;
  });
  return sums;
}

Slopes slopes_of(const Rules& rules) {
  double wide = 0, narrow = 0;
  for (const Taps& taps : rules.taps) {
    wide += taps.variance() / 3;
    narrow += narrower(taps, thin_taps()).variance() / 3;
  }
  // Interpolation smooths by a variance of 1/6.
  return {slope_of(std::sqrt(wide + 1.0 / 6)), slope_of(std::sqrt(narrow + 1.0 / 6))};
}

}  // namespace

Constants volume_constants(const NodeFields& fields, const MaterialImage& image,
                           const Rules& rules, const Context& context) {
  Constants constants(image.labels().size() + 1, 0);
  const Slopes slopes = slopes_of(rules);
  for (int pass = 0; pass < passes; ++pass) {
    const RegionSums sums = estimate(fields, image, slopes, constants, rules.hold, context);
    for (std::size_t m = 1; m < constants.size(); ++m) {
      if (sums.area[m] == 0) continue;
      const double voxels = static_cast<double>(image.voxels()[m - 1]) * volume_unit;
      const double excess = (static_cast<double>(sums.volume[m]) - voxels) /
                            static_cast<double>(sums.area[m]);
      const double moved = constants[m] - moved_at_once * field_one * excess;
      constants[m] = static_cast<std::int32_t>(
          std::lround(std::clamp<double>(moved, -greatest_constant, greatest_constant)));
    }
  }
  return constants;
}

}  // namespace certet::fields
