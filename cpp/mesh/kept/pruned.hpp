#pragma once
/// \file
/// A domain of which small blocks are known, so that a fine lattice asks little of it.

#include <cstdint>
#include <vector>

#include "certet/placed_domain.hpp"

namespace certet::core {

/// Asks for the extents of blocks, of those that are mixed for those of their parts, and
/// answers rows of one solid.  The domain must live as long.
class PrunedDomain final : public Domain {
 public:
  explicit PrunedDomain(const PlacedDomain& domain);

  /// Cells of the lattice in small blocks that are mixed.
  [[nodiscard]] double mixed_cells() const { return mixed_cells_; }

  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    domain_.at(positions, out);
  }
  [[nodiscard]] std::size_t batch() const override { return domain_.batch(); }
  /// Known where the box is in a block.
  [[nodiscard]] Extent extent(const LatticeBox& box) const override;
  [[nodiscard]] bool even_points_tell_pieces() const override {
    return domain_.even_points_tell_pieces();
  }

 private:
  /// In lattice units: a small block, and small ones along a side of a large one.
  static constexpr std::int32_t side = 8, parts = 4;

  void divide(Coord3 block);
  [[nodiscard]] std::size_t index(Coord3 block) const;
  [[nodiscard]] Coord3 block_of(Coord3 point) const;
  [[nodiscard]] Extent extent_of(Coord3 block, std::int32_t length) const;

  const PlacedDomain& domain_;
  Coord3 count_{};  ///< of small blocks, along the axes
  std::vector<Extent> known_;
  double mixed_cells_ = 0;
};

}  // namespace certet::core
