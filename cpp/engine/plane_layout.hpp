#pragma once
/// \file
/// Where the bits of lattice vertices stand.

#include <array>
#include <cstddef>
#include <cstdint>

#include "window.hpp"

namespace certet::core {

/// Number of the 64 vertices in a word that come before bit b, as a mask.
constexpr std::uint64_t below(int b) { return (std::uint64_t{1} << b) - 1; }

/// A plane has a bit for each vertex of a grid, row by row.  It has a rim of one row, one
/// layer and one word on each side, and holds the layers of a window; where that ends
/// before the lattice does, the rim's layer means nothing.
class PlaneLayout {
 public:
  PlaneLayout(const std::array<std::int32_t, 3>& cells, Window window)
      : cells_(cells), window_(window), words_((cells[0] + 63) / 64), row_stride_(words_ + 2),
        layer_stride_(static_cast<std::size_t>(row_stride_) *
                      static_cast<std::size_t>(cells[1] + 2)) {}
  /// The same, of other layers.
  PlaneLayout(const PlaneLayout& other, Window window) : PlaneLayout(other.cells_, window) {}

  [[nodiscard]] const std::array<std::int32_t, 3>& cells() const { return cells_; }
  [[nodiscard]] Window window() const { return window_; }
  /// Of a row, without the rim.
  [[nodiscard]] int words() const { return words_; }
  /// Words of a plane.
  [[nodiscard]] std::size_t size() const {
    return layer_stride_ * static_cast<std::size_t>(window_.layers() + 2);
  }
  /// Where a layer begins, with its rim.
  [[nodiscard]] std::size_t layer(int k) const {
    return static_cast<std::size_t>(k + 1 - window_.begin) * layer_stride_;
  }
  /// Word 0 of a row.
  [[nodiscard]] std::size_t at(int j, int k) const {
    return layer(k) +
           static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(row_stride_) + 1;
  }

 private:
  std::array<std::int32_t, 3> cells_;
  Window window_;
  int words_;
  int row_stride_;
  std::size_t layer_stride_;
};

/// Word w of a row as seen from vertices whose index is `shift` smaller; the row's words
/// are `stride` apart.
inline std::uint64_t shifted(const std::uint64_t* row, int w, int shift, int stride = 1) {
  const std::uint64_t* const word = row + w * stride;
  if (shift > 0) return *word >> 1 | word[stride] << 63;
  if (shift < 0) return *word << 1 | word[-stride] >> 63;
  return *word;
}

}  // namespace certet::core
