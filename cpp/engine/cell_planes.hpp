#pragma once
/// \file
/// The cells of an octree over the lattice, a bit each.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/lattice.hpp"

namespace certet::core {

/// What a plane of some level has a bit for: cells, or the corners of cells, each by the index
/// of the cell that it is the lowest corner of.  Cell (0,0,0) of every level is the one in
/// which the lattice's first index lies; which cells are children of one depends on where the
/// lattice lies among all, so that a mesh does not depend on what is searched around it.
struct LevelGrid {
  std::array<std::int32_t, 3> cells;  ///< so many touch the lattice
  std::array<std::int32_t, 3> first;  ///< the index of the first among all of its level

  /// That of level 0, of which every index of the lattice has a cell.
  explicit LevelGrid(const Lattice& lattice);
  /// The one a level above.
  [[nodiscard]] LevelGrid coarser() const;
  /// Whether the first cell is an upper child of its parent: 0 or 1.
  [[nodiscard]] int is_upper(std::size_t axis) const { return first[axis] & 1; }
  [[nodiscard]] int words() const { return (cells[0] + 63) / 64; }
};

/// A row of bits.  All that lie beyond it are set.
class BitRow {
 public:
  BitRow(const std::uint64_t* words, int count) : words_(words), count_(count) {}

  [[nodiscard]] std::uint64_t operator[](int w) const {
    return static_cast<unsigned>(w) < static_cast<unsigned>(count_) ? words_[w]
                                                                   : ~std::uint64_t{0};
  }
  [[nodiscard]] bool at(int i) const { return ((*this)[i >> 6] >> (i & 63) & 1) != 0; }
  /// Bits 64 w + shift and so on, for any shift.
  [[nodiscard]] std::uint64_t shifted(int w, int shift) const {
    const int from = 64 * w + shift;
    const int b = from & 63;
    const std::uint64_t low = (*this)[from >> 6] >> b;
    return b == 0 ? low : low | (*this)[(from >> 6) + 1] << (64 - b);
  }

 private:
  const std::uint64_t* words_;
  int count_;  ///< none of a row in which all bits are set
};

/// Every second bit of a word, in its lower half.
constexpr std::uint64_t squeezed(std::uint64_t x) {
  x &= 0x5555555555555555;
  x = (x | x >> 1) & 0x3333333333333333;
  x = (x | x >> 2) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x >> 4) & 0x00ff00ff00ff00ff;
  x = (x | x >> 8) & 0x0000ffff0000ffff;
  return (x | x >> 16) & 0x00000000ffffffff;
}

/// Every second bit of two words, from the lowest on.
constexpr std::uint64_t every_second(std::uint64_t low, std::uint64_t high) {
  return squeezed(low) | squeezed(high) << 32;
}

/// A bit for each cell of a level.  Those that touch no index of the lattice have theirs set.
class CellPlane {
 public:
  explicit CellPlane(const LevelGrid& grid);

  [[nodiscard]] const LevelGrid& grid() const { return grid_; }
  [[nodiscard]] std::uint64_t* words(int j, int k) { return &words_[at(j, k)]; }
  [[nodiscard]] const std::uint64_t* words(int j, int k) const { return &words_[at(j, k)]; }
  [[nodiscard]] BitRow row(int j, int k) const {
    const bool inside = j >= 0 && j < grid_.cells[1] && k >= 0 && k < grid_.cells[2];
    return inside ? BitRow(&words_[at(j, k)], grid_.words()) : BitRow(nullptr, 0);
  }
  [[nodiscard]] std::size_t bytes() const { return sizeof(std::uint64_t) * words_.size(); }

 private:
  [[nodiscard]] std::size_t at(int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid_.cells[1]) +
            static_cast<std::size_t>(j)) *
           static_cast<std::size_t>(grid_.words());
  }

  LevelGrid grid_;
  std::vector<std::uint64_t> words_;
};

}  // namespace certet::core
