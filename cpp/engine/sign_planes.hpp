#pragma once
/// \file
/// The signs of lattice vertices, two bits each.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/lattice/sign.hpp"
#include "lattice/lattice_edges.hpp"
#include "window.hpp"

namespace certet::core {

/// Number of the 64 vertices in a word that come before bit b, as a mask.
constexpr std::uint64_t below(int b) { return (std::uint64_t{1} << b) - 1; }

/// Bit planes: a row of the lattice (fixed j and k) is `words()` words of 64
/// vertices; bit b of word w is index i = 64 w + b.  A vertex that is neither
/// plus nor zero is minus, and so is everything around the lattice: the planes
/// have a rim of one row, one layer and one word on each side.  They hold the
/// layers of a window; where that ends before the lattice does, the rim's layer
/// means nothing.
class SignPlanes {
 public:
  SignPlanes(const std::array<std::int32_t, 3>& cells, Window window)
      : cells_(cells),
        window_(window),
        words_((cells[0] + 63) / 64),
        row_stride_(words_ + 2),
        layer_stride_(static_cast<std::size_t>(row_stride_) *
                      static_cast<std::size_t>(cells[1] + 2)) {
    const std::size_t words = layer_stride_ * static_cast<std::size_t>(window.layers() + 2);
    for (std::size_t g = 0; g < grid_count; ++g) {
      plus_[g].resize(words);
      zero_[g].resize(words);
    }
  }

  /// A copy of some of the layers of `other`.
  SignPlanes(const SignPlanes& other, Window window)
      : cells_(other.cells_),
        window_(window),
        words_(other.words_),
        row_stride_(other.row_stride_),
        layer_stride_(other.layer_stride_) {
    const auto begin = static_cast<std::ptrdiff_t>(other.layer(window.begin - 1));
    const auto end = static_cast<std::ptrdiff_t>(other.layer(window.end + 1));
    for (std::size_t g = 0; g < grid_count; ++g) {
      plus_[g].assign(other.plus_[g].begin() + begin, other.plus_[g].begin() + end);
      zero_[g].assign(other.zero_[g].begin() + begin, other.zero_[g].begin() + end);
    }
  }

  /// Turns every zero vertex to minus.
  void clear_zeros() {
    for (std::vector<std::uint64_t>& words : zero_) std::ranges::fill(words, 0);
  }

  /// Of the lattice.
  [[nodiscard]] const std::array<std::int32_t, 3>& cells() const { return cells_; }
  [[nodiscard]] Window window() const { return window_; }
  [[nodiscard]] int words() const { return words_; }

  /// Word 0 of a row; words -1 to words() may be read, rows from -1 to their
  /// number, and the layers of the window and one on each side.
  [[nodiscard]] std::uint64_t* plus(std::size_t grid, int j, int k) { return &plus_[grid][at(j, k)]; }
  [[nodiscard]] std::uint64_t* zero(std::size_t grid, int j, int k) { return &zero_[grid][at(j, k)]; }
  [[nodiscard]] const std::uint64_t* plus(std::size_t grid, int j, int k) const {
    return &plus_[grid][at(j, k)];
  }
  [[nodiscard]] const std::uint64_t* zero(std::size_t grid, int j, int k) const {
    return &zero_[grid][at(j, k)];
  }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(std::uint64_t) * 2 * grid_count * plus_[0].size();
  }
  /// The bytes that planes of this size will take.
  static std::uint64_t bytes_for(const std::array<std::int32_t, 3>& cells) {
    return std::uint64_t{2 * grid_count} * sizeof(std::uint64_t) *
           static_cast<std::uint64_t>((cells[0] + 63) / 64 + 2) *
           static_cast<std::uint64_t>(cells[1] + 2) * static_cast<std::uint64_t>(cells[2] + 2);
  }

 private:
  /// Where a layer begins, with its rim.
  [[nodiscard]] std::size_t layer(int k) const {
    return static_cast<std::size_t>(k + 1 - window_.begin) * layer_stride_;
  }
  [[nodiscard]] std::size_t at(int j, int k) const {
    return layer(k) +
           static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(row_stride_) + 1;
  }

  std::array<std::int32_t, 3> cells_;
  Window window_;
  int words_;
  int row_stride_;
  std::size_t layer_stride_;
  std::array<std::vector<std::uint64_t>, grid_count> plus_, zero_;
};

/// Word w of a row as seen from vertices whose index is `shift` smaller.
inline std::uint64_t shifted(const std::uint64_t* row, int w, int shift) {
  if (shift > 0) return row[w] >> 1 | row[w + 1] << 63;
  if (shift < 0) return row[w] << 1 | row[w - 1] >> 63;
  return row[w];
}

/// The signs of 64 vertices.
struct SignWord {
  std::uint64_t plus, zero;
  [[nodiscard]] constexpr std::uint64_t minus() const { return ~(plus | zero); }
};

/// Signs as seen from a row: addresses are worked out once for all its words.
class SignRows {
 public:
  SignRows(const SignPlanes& planes, int j, int k)
      : row_stride_(planes.plus(0, j + 1, k) - planes.plus(0, j, k)),
        layer_stride_(planes.plus(0, j, k + 1) - planes.plus(0, j, k)) {
    for (std::size_t g = 0; g < grid_count; ++g) {
      plus_[g] = planes.plus(g, j, k);
      zero_[g] = planes.zero(g, j, k);
    }
  }

  /// The vertices at `ref` from the indices of word w.
  [[nodiscard]] SignWord at(VertexRef ref, int w) const {
    const std::ptrdiff_t row = ref.shift.y * row_stride_ + ref.shift.z * layer_stride_;
    return {shifted(plus_[ref.grid] + row, w, ref.shift.x),
            shifted(zero_[ref.grid] + row, w, ref.shift.x)};
  }

 private:
  std::array<const std::uint64_t*, grid_count> plus_, zero_;
  std::ptrdiff_t row_stride_, layer_stride_;
};

}  // namespace certet::core
