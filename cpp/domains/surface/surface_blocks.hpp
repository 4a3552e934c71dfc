#pragma once
/// \file
/// Which blocks of the lattice the surface may pass through.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "certet/lattice.hpp"
#include "exact.hpp"

namespace certet {

/// Cubes of lattice points, of at least 32 lattice units.
class SurfaceBlocks {
 public:
  explicit SurfaceBlocks(const Lattice& lattice);

  /// Marks the blocks that a triangle passes through, and maybe some that it
  /// passes near to.
  void add(const exact::Corners& triangle);

  /// False only if no marked block meets the box.
  [[nodiscard]] bool any(const LatticeBox& box) const;
  [[nodiscard]] std::uint64_t bytes() const { return marked_.size() / 8; }

 private:
  struct Range {
    std::array<std::int64_t, 3> low, high;  ///< blocks, both ends included
  };
  /// Positions in steps.
  [[nodiscard]] Range range(Coord3 low, Coord3 high) const;
  [[nodiscard]] std::size_t block(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * count_[1] + y) * count_[0] + x);
  }

  std::array<std::int64_t, 3> origin_, count_;
  std::int64_t side_;  ///< in steps
  std::vector<bool> marked_;
};

}  // namespace certet
