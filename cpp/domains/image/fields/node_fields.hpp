#pragma once
/// \file
/// The fields of all labels of an image.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "certet/context.hpp"
#include "fields/field_tile.hpp"
#include "fields/hold.hpp"
#include "fields/material_image.hpp"
#include "fields/rules.hpp"
#include "fields/treads.hpp"

namespace certet::fields {

/// Cells low to high along each axis, both ends included.
struct CellBox {
  Cell low, high;
};

/// A field u for each label, in 16384ths at nodes and trilinear between them:
///   - the share of its voxels among those around a node, weighted by the taps, or by
///     (3 10 3)/16 near thin voxels, where surfaces that run almost along the planes of
///     voxels have become slopes (`Treads`);
///   - and a constant for each label by which the region where it is the greatest has
///     the volume of its voxels (`volume_constants`);
///   - changed so that at every voxel's centre its own label is the greatest (`hold`).
/// All numbers are whole, and the same for any number of threads.
class NodeFields {
 public:
  /// \throws Error `cancelled`.
  NodeFields(const MaterialImage& image, const Rules& rules, const Context& context);

  /// The block of a cell.  Cells are numbered from 0 to the number of voxels.
  [[nodiscard]] BlockView block(const Cell& cell) const {
    const auto along = [&](std::size_t a) { return static_cast<std::uint64_t>(cell[a]); };
    const auto tile = [&](std::size_t a) {
      return static_cast<std::int64_t>(along(a) / tile_cells);
    };
    const std::size_t t = tile_number(tile(0), tile(1), tile(2));
    if (!tiles_[t]) return {.only = only_[t]};
    const auto block = [&](std::size_t a) {
      return static_cast<int>(along(a) / block_cells % tile_blocks);
    };
    return tiles_[t]->view(tiles_[t]->blocks[block_number(block(0), block(1), block(2))]);
  }

  /// The material that all points of some cells have, where none other is near.
  [[nodiscard]] std::optional<Material> only_material(const CellBox& cells) const;

  [[nodiscard]] std::uint64_t bytes() const;

  [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
  /// Of a tile by its number.
  [[nodiscard]] Cell first_cell(std::size_t number) const {
    const auto n = static_cast<std::int64_t>(number);
    return {tile_cells * (n % counts_[0]), tile_cells * (n / counts_[0] % counts_[1]),
            tile_cells * (n / counts_[0] / counts_[1])};
  }
  /// nullptr where there is but one material.
  [[nodiscard]] const Tile* tile(std::size_t number) const { return tiles_[number].get(); }
  [[nodiscard]] Material only(std::size_t number) const { return only_[number]; }
  [[nodiscard]] const Constants& constants() const { return constants_; }
  /// How many voxels a region gains about if its constant grows by 1; none where volumes are not
  /// kept.
  [[nodiscard]] const std::vector<double>& growths() const { return growths_; }
  /// The same with other constants, of the image and by the rules that these are of.  Tiles
  /// without labels whose constants have changed are shared.
  [[nodiscard]] NodeFields with(Constants constants, const MaterialImage& image,
                                const Rules& rules, const Context& context) const;

  /// Calls visit(block, its first cell) for all blocks of a tile.
  template <class Visit>
  void for_each_block(std::size_t tile, const Visit& visit) const {
    const Cell first = first_cell(tile);
    for_each_of_cube(tile_blocks, [&](int x, int y, int z) {
      const Cell cell{first[0] + block_cells * x, first[1] + block_cells * y,
                      first[2] + block_cells * z};
      visit(block(cell), cell);
    });
  }

 private:
  [[nodiscard]] std::size_t tile_number(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * counts_[1] + y) * counts_[0] + x);
  }
  void make_tiles(const MaterialImage& image, const Rules& rules, const Context& context);
  void finish_tiles(bool hold, const Context& context);

  std::array<std::int64_t, 3> counts_;  ///< of tiles
  std::vector<std::shared_ptr<Tile>> tiles_;  ///< not changed once they are finished
  std::vector<Material> only_;  ///< of tiles of one material
  std::shared_ptr<const Treads> treads_;
  Constants constants_;
  std::vector<double> growths_;
};

}  // namespace certet::fields
