#include "node_fields.hpp"

#include <algorithm>
#include <utility>

#include "fields/for_each_tile.hpp"
#include "fields/make_tile.hpp"
#include "fields/volume_constants.hpp"

namespace certet::fields {
namespace {

/// In place.
void finish_tile(Tile& tile, const Constants& constants, bool hold) {
  HeldBlock held;
  for (const Block& block : tile.blocks) {
    if (block.labels == 0) continue;
    raise_and_hold(tile.view(block), constants, hold, held);
    std::ranges::copy(held.values, &tile.values[nodes_of_block * block.first]);
  }
}

}  // namespace

NodeFields::NodeFields(const MaterialImage& image, const Rules& rules, const Context& context) {
  // The last cell lies between the last voxel and the node added behind it.
  for (std::size_t a = 0; a < 3; ++a) counts_[a] = image.size()[a] / tile_cells + 1;
  const auto tiles = static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]);
  tiles_.resize(tiles);
  only_.resize(tiles, 0);
  make_tiles(image, rules, context);
  constants_.assign(image.labels().size() + 1, 0);
  if (rules.keep_volumes) {
    auto [constants, growths] = volume_constants(*this, image, rules, context);
    constants_ = std::move(constants);
    growths_ = std::move(growths);
  }
  finish_tiles(rules.hold, context);
}

void NodeFields::make_tiles(const MaterialImage& image, const Rules& rules,
                            const Context& context) {
  const int halo = halo_of(rules);
  treads_ = rules.slope_treads ? std::make_shared<const Treads>(image, context)
                               : std::make_shared<const Treads>();
  // Along the first axis one after the other.
  const auto row = static_cast<std::size_t>(counts_[0]);
  for_each_tile(context, tiles_.size() / row, [&](std::size_t r) {
    TileMaker maker(rules);
    for (std::size_t t = r * row; t < (r + 1) * row; ++t) {
      const LabelWindow window = window_around(image, *treads_, first_cell(t), halo);
      only_[t] = window.materials.front();
      tiles_[t] = maker.make(window);
    }
  });
}

void NodeFields::finish_tiles(bool hold, const Context& context) {
  for_each_tile(context, tiles_.size(), [&](std::size_t t) {
    if (tiles_[t]) finish_tile(*tiles_[t], constants_, hold);
  });
}

NodeFields NodeFields::with(Constants constants, const MaterialImage& image, const Rules& rules,
                            const Context& context) const {
  NodeFields other(*this);
  other.constants_ = std::move(constants);
  const auto has_changed = [&](Material material) {
    const auto m = static_cast<std::size_t>(material);
    return other.constants_[m] != constants_[m];
  };
  const int halo = halo_of(rules);
  for_each_tile(context, tiles_.size(), [&](std::size_t t) {
    if (!tiles_[t] || std::ranges::none_of(tiles_[t]->materials, has_changed)) return;
    other.tiles_[t] = TileMaker(rules).make(window_around(image, *treads_, first_cell(t), halo));
    finish_tile(*other.tiles_[t], other.constants_, rules.hold);
  });
  return other;
}

std::optional<Material> NodeFields::only_material(const CellBox& cells) const {
  std::optional<Material> found;
  const auto differs = [&](Material material) {
    if (!found) found = material;
    return *found != material;
  };
  // From the first cell of one block to the first of the next.
  const auto next = [](std::int64_t cell) { return (cell / block_cells + 1) * block_cells; };
  for (std::int64_t z = cells.low[2]; z <= cells.high[2]; z = next(z))
    for (std::int64_t y = cells.low[1]; y <= cells.high[1]; y = next(y))
      for (std::int64_t x = cells.low[0]; x <= cells.high[0]; x = next(x)) {
        const BlockView view = block({x, y, z});
        if (view.labels != 0 || differs(view.only)) return std::nullopt;
      }
  return found;
}

std::uint64_t NodeFields::bytes() const {
  std::uint64_t sum = tiles_.size() * (sizeof(tiles_[0]) + sizeof(only_[0])) +
                      constants_.size() * sizeof(constants_[0]);
  for (const auto& tile : tiles_)
    if (tile) sum += tile->bytes();
  return sum;
}

}  // namespace certet::fields
