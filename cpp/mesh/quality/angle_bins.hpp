#pragma once
/// \file
/// Which bin of the histogram an angle falls into, without its arc cosine.

#include <array>
#include <cstdint>

#include "certet/quality.hpp"

namespace certet::core {

/// Bins by the square of the cosine, with the cosine's sign: it falls from 1 to
/// -1 as the angle grows from 0 to 180 degrees, needs no square root, and is
/// exact at 30, 45, 60, 90, … degrees, where the lattice has its angles.
class AngleBins {
 public:
  /// So many cells over [-1, 1] that none holds two edges of bins.
  static constexpr std::int32_t cells = 512;

  AngleBins();

  /// The cell of a value in [-1, 1].
  static std::int32_t cell(double signed_square) {
    return static_cast<std::int32_t>((signed_square + 1) * (0.5 * cells));
  }
  /// The bin of a value and its cell.  An edge belongs to the bin above it.
  [[nodiscard]] std::size_t bin(double signed_square, std::int32_t cell) const {
    const Cell& c = cells_[static_cast<std::size_t>(cell)];
    return c.bin + (signed_square > c.edge ? 0u : 1u);
  }

 private:
  /// Values above `edge` fall into `bin`, the others into the next.
  struct Cell {
    double edge;
    std::size_t bin;
  };
  std::array<Cell, cells + 1> cells_;
};

/// The one table, made at first use.
const AngleBins& angle_bins();

}  // namespace certet::core
