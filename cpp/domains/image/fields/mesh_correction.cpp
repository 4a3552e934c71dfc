#include "mesh_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "fields/mesh_volumes.hpp"
#include "fields/volume_constants.hpp"

namespace certet::fields {
namespace {

constexpr std::uint64_t fewest_voxels = 1000, few_voxels = 5000, most_voxels = 12000;
/// Of larger regions those are looked at that have so much surface, or so great a constant: no
/// others were found to be off by more than 0.8 %.
constexpr double least_growth = 0.9;  ///< of a voxel's, in voxels
constexpr std::int32_t least_constant = 6 * field_one / 100;
constexpr double tolerated = 0.008;
constexpr int rounds = 6;
/// Cells around a region, which its mesh depends on.
constexpr std::int32_t around = 4;

/// A region whose volume is looked at.
struct Region {
  Material material;
  double voxels;
  Lattice part;
  double growth;                    ///< voxels that it gains if its constant grows by 1
  bool is_open = true;              ///< not measured since something near has changed
  double volume = 0, constant = 0;  ///< when it was last changed
  bool has_changed = false;
  double missing = 0;  ///< voxels, when it was last measured

  /// By how much of its volume it is off, beyond what is tolerated.
  [[nodiscard]] double excess() const {
    return std::max(0.0, std::abs(missing) / voxels - tolerated);
  }

  /// Held and thin parts grow by less than areas tell: from the second time on by what was seen.
  void learn(double measured, double now) {
    if (has_changed && now != constant)
      growth = std::clamp((measured - volume) / (now - constant), growth / 2, growth);
    volume = measured;
    constant = now;
    has_changed = true;
  }
};

/// Boxes around some materials, by material.
std::vector<VoxelBox> boxes_of(const MaterialImage& image, const std::vector<bool>& asked) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::vector<VoxelBox> boxes(asked.size(), {{most, most, most}, {-1, -1, -1}});
  const VoxelBox& bounds = image.bounds();
  const std::int64_t count = bounds.high[0] - bounds.low[0] + 1;
  std::vector<Material> row(static_cast<std::size_t>(count));
  for (std::int64_t z = bounds.low[2]; z <= bounds.high[2]; ++z)
    for (std::int64_t y = bounds.low[1]; y <= bounds.high[1]; ++y) {
      image.read_row({bounds.low[0], y, z}, count, row.data(), 1);
      for (std::size_t begin = 0, end = 0; begin < row.size(); begin = end) {
        while (end < row.size() && row[end] == row[begin]) ++end;
        const auto material = static_cast<std::size_t>(row[begin]);
        if (!asked[material]) continue;
        VoxelBox& box = boxes[material];
        const std::int64_t first = bounds.low[0] + static_cast<std::int64_t>(begin),
                           last = bounds.low[0] + static_cast<std::int64_t>(end) - 1;
        box.low = {std::min(box.low[0], first), std::min(box.low[1], y), std::min(box.low[2], z)};
        box.high = {std::max(box.high[0], last), std::max(box.high[1], y),
                    std::max(box.high[2], z)};
      }
    }
  return boxes;
}

/// The part of the lattice that holds a box.
Lattice part_around(const Placement& placement, const VoxelBox& box) {
  Lattice part = placement.lattice;
  const std::array<std::int32_t*, 3> origin{&part.origin.x, &part.origin.y, &part.origin.z};
  for (std::size_t a = 0; a < 3; ++a) {
    const VoxelAxis& axis = placement.axis[a];
    const std::int64_t one = axis.stored(box.low[a]), other = axis.stored(box.high[a]);
    const auto cell_at = [&](std::int64_t forward) {
      return ((static_cast<double>(forward) - axis.shift) / axis.scale - *origin[a]) / 2;
    };
    const auto low = static_cast<std::int32_t>(std::floor(cell_at(std::min(one, other)))) - around;
    const auto high = static_cast<std::int32_t>(std::ceil(cell_at(std::max(one, other)))) + around;
    const std::int32_t first = std::max(low, 0), last = std::min(high, part.cells[a]);
    *origin[a] += 2 * first;
    part.cells[a] = last - first;
  }
  return part;
}

/// Whether a region may be off in the mesh by more than is tolerated.
bool may_be_off(std::uint64_t voxels, double growth, std::int32_t constant) {
  if (voxels < fewest_voxels || voxels > most_voxels) return false;
  return voxels <= few_voxels || growth >= least_growth * static_cast<double>(voxels) ||
         std::abs(constant) >= least_constant;
}

std::vector<Region> regions_of(const MaterialImage& image, const Placement& placement,
                               const NodeFields& nodes) {
  const std::vector<double>& growths = nodes.growths();
  std::vector<bool> asked(image.labels().size() + 1, false);
  for (std::size_t m = 1; m < asked.size(); ++m)
    asked[m] = may_be_off(image.voxels()[m - 1], growths[m], nodes.constants()[m]);
  std::vector<Region> regions;
  if (std::ranges::find(asked, true) == asked.end()) return regions;
  const std::vector<VoxelBox> boxes = boxes_of(image, asked);
  for (std::size_t m = 1; m < asked.size(); ++m)
    if (asked[m])
      regions.push_back({static_cast<Material>(m), static_cast<double>(image.voxels()[m - 1]),
                         part_around(placement, boxes[m]), growths[m]});
  return regions;
}

bool overlap(const Lattice& one, const Lattice& other) {
  const auto apart = [](std::int32_t a, std::int32_t cells_a, std::int32_t b,
                        std::int32_t cells_b) {
    return a + 2 * cells_a <= b || b + 2 * cells_b <= a;
  };
  return !apart(one.origin.x, one.cells[0], other.origin.x, other.cells[0]) &&
         !apart(one.origin.y, one.cells[1], other.origin.y, other.cells[1]) &&
         !apart(one.origin.z, one.cells[2], other.origin.z, other.cells[2]);
}

/// How many voxels a cell of the lattice is as large as.
double voxels_of_cell(const Placement& placement) {
  double voxels = 1;
  for (const VoxelAxis& axis : placement.axis) voxels *= 2 * axis.scale;
  return voxels;
}

void measure(std::vector<Region>& regions, const Domain& domain, double voxels_of_cell,
             const Context& context) {
  std::vector<RegionPart> parts;
  for (const Region& region : regions)
    if (region.is_open) parts.push_back({region.material, region.part});
  const std::vector<double> volumes = mesh_volumes(domain, parts, context);
  auto volume = volumes.begin();
  for (Region& region : regions)
    if (std::exchange(region.is_open, false))
      region.missing = region.voxels - *volume++ * voxels_of_cell;
}

/// Changes the constants of those that are off; what is near them is open again.
void correct(std::vector<Region>& regions, Constants& constants) {
  std::vector<Region> changed;
  for (Region& region : regions) {
    if (region.excess() == 0) continue;
    std::int32_t& constant = constants[static_cast<std::size_t>(region.material)];
    const double now = static_cast<double>(constant) / field_one;
    region.learn(region.voxels - region.missing, now);
    constant = bounded_constant(field_one * (now + region.missing / region.growth));
    changed.push_back(region);
  }
  for (Region& region : regions)
    region.is_open = std::ranges::any_of(
        changed, [&](const Region& other) { return overlap(region.part, other.part); });
}

}  // namespace

std::shared_ptr<const NodeFields> corrected_by_mesh(std::shared_ptr<const LabelFields> fields,
                                                    const Placement& placement,
                                                    const DomainOf& domain_of,
                                                    const Context& context) {
  std::shared_ptr<const NodeFields> nodes(fields, &fields->nodes);
  const double voxels = voxels_of_cell(placement);
  const Rules& rules = fields->rules;
  if (!rules.keep_volumes || !rules.correct_by_mesh || voxels > 1.001) return nodes;
  std::vector<Region> regions = regions_of(fields->image, placement, *nodes);
  // Where voxels are held a region may become worse: of all rounds the best is taken.
  std::shared_ptr<const NodeFields> best = nodes;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds && !regions.empty(); ++round) {
    measure(regions, *domain_of(nodes), voxels, context);
    double excess = 0;
    for (const Region& region : regions) excess += region.excess();
    if (excess < least) {
      least = excess;
      best = nodes;
    }
    if (excess == 0 || round + 1 == rounds) break;
    Constants constants = nodes->constants();
    correct(regions, constants);
    nodes = std::make_shared<const NodeFields>(
        nodes->with(std::move(constants), fields->image, rules, context));
  }
  return best;
}

}  // namespace certet::fields
