#include "volume_constants.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "fields/for_each_tile.hpp"
#include "fields/node_fields.hpp"
#include "fields/region_estimate.hpp"

namespace certet::fields {
namespace {

constexpr int passes = 4;
/// More than 1, for held and thin parts move less than the others.
constexpr double moved_at_once = 1.2;
constexpr std::int32_t greatest_constant = 14746;  ///< 0.9, so that 16 bits hold all fields
constexpr int rounds = 100;  ///< of the solver
constexpr double least_area = 5;  ///< in faces of a voxel

double in_voxels(std::int64_t sum) {
  return static_cast<double>(sum) / static_cast<double>(RegionSums::unit);
}

/// Of all tiles, merged in any order.
RegionSums estimate(const NodeFields& fields, const MaterialImage& image, const Slopes& slopes,
                    const Constants& constants, bool hold, const Context& context) {
  RegionSums sums(constants.size());
  std::mutex mutex;
  for_each_tile(context, fields.tile_count(), [&](std::size_t t) {
    RegionSums of_tile(constants.size());
    TileEstimate estimate(image.size(), slopes, of_tile);
    const Cell first = fields.first_cell(t);
    if (fields.tile(t) == nullptr)
      estimate.add_uniform(fields.only(t), first, tile_cells);
    else
      fields.for_each_block(t, [&](const BlockView& block, const Cell& cell) {
        estimate.add_block(block, cell, constants, hold);
      });
    of_tile.merge_areas();
    const std::lock_guard lock(mutex);
    sums.add(of_tile);
  });
  sums.merge_areas();
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

/// What each region has of areas, but at least a little: what is as small as a voxel may lie
/// between all points.
std::vector<double> growths_of(const RegionSums& sums, std::size_t materials) {
  std::vector<double> growths(materials, 0);
  for (const auto& [low, high, area] : sums.areas())
    for (const Material of : {low, high}) growths[static_cast<std::size_t>(of)] += in_voxels(area);
  for (double& growth : growths) growth = std::max(growth, least_area);
  return growths;
}

/// By how much each constant is to change for volumes to change by `excess` less, in
/// voxels: what a label's region gains along a surface is what its own constant changes
/// by, less what the other's does.  By Gauss and Seidel; the outside's stays.
std::vector<double> changes(const RegionSums& sums, const std::vector<double>& growths,
                            const std::vector<double>& excess) {
  struct Neighbour {
    std::size_t of;
    double area;
  };
  std::vector<std::vector<Neighbour>> neighbours(excess.size());
  for (const auto& [low, high, area] : sums.areas()) {
    const auto a = static_cast<std::size_t>(low), b = static_cast<std::size_t>(high);
    const double faces = in_voxels(area);
    neighbours[a].push_back({b, faces});
    neighbours[b].push_back({a, faces});
  }
  std::vector<double> change(excess.size(), 0);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t m = 1; m < change.size(); ++m) {
      double sum = -excess[m];
      for (const Neighbour& n : neighbours[m]) sum += n.area * change[n.of];
      change[m] = sum / growths[m];
    }
  return change;
}

}  // namespace

std::int32_t bounded_constant(double constant) {
  return static_cast<std::int32_t>(
      std::lround(std::clamp<double>(constant, -greatest_constant, greatest_constant)));
}

VolumeConstants volume_constants(const NodeFields& fields, const MaterialImage& image,
                                 const Rules& rules, const Context& context) {
  VolumeConstants found{Constants(image.labels().size() + 1, 0), {}};
  auto& [constants, growths] = found;
  std::vector<double> excess(constants.size(), 0);
  const Slopes slopes = slopes_of(rules);
  for (int pass = 0; pass < passes; ++pass) {
    const RegionSums sums = estimate(fields, image, slopes, constants, rules.hold, context);
    growths = growths_of(sums, constants.size());
    for (std::size_t m = 1; m < constants.size(); ++m)
      excess[m] = in_voxels(sums.volumes()[m]) - static_cast<double>(image.voxels()[m - 1]);
    const std::vector<double> change = changes(sums, growths, excess);
    for (std::size_t m = 1; m < constants.size(); ++m)
      constants[m] = bounded_constant(constants[m] + moved_at_once * field_one * change[m]);
  }
  return found;
}

}  // namespace certet::fields
