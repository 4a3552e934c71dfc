#pragma once
/// \file
/// The signs of lattice vertices, two bits each.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "certet/lattice/sign.hpp"
#include "lattice/lattice_edges.hpp"
#include "material_planes.hpp"
#include "plane_layout.hpp"
#include "window.hpp"

namespace certet::core {

/// Bit planes: a row of the lattice (fixed j and k) is `words()` words of 64
/// vertices; bit b of word w is index i = 64 w + b.  A vertex that is neither
/// plus nor zero is minus, and so is everything around the lattice.
///
/// Where several materials meet, plus says that a vertex is of some material and has not
/// moved to the surface of one; `materials` says of which.
class SignPlanes {
 public:
  SignPlanes(const std::array<std::int32_t, 3>& cells, Window window)
      : layout_(cells, window) {
    for (std::size_t g = 0; g < grid_count; ++g) {
      plus_[g].resize(layout_.size());
      zero_[g].resize(layout_.size());
    }
  }

  /// A copy of some of the layers of `other`.
  SignPlanes(const SignPlanes& other, Window window)
      : layout_(other.layout_, window), materials_(other.materials_) {
    const auto begin = static_cast<std::ptrdiff_t>(other.layout_.layer(window.begin - 1));
    const auto end = static_cast<std::ptrdiff_t>(other.layout_.layer(window.end + 1));
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
  [[nodiscard]] const std::array<std::int32_t, 3>& cells() const { return layout_.cells(); }
  [[nodiscard]] Window window() const { return layout_.window(); }
  [[nodiscard]] int words() const { return layout_.words(); }
  [[nodiscard]] const PlaneLayout& layout() const { return layout_; }

  /// Word 0 of a row; words -1 to words() may be read, rows from -1 to their
  /// number, and the layers of the window and one on each side.
  [[nodiscard]] std::uint64_t* plus(std::size_t grid, int j, int k) {
    return &plus_[grid][layout_.at(j, k)];
  }
  [[nodiscard]] std::uint64_t* zero(std::size_t grid, int j, int k) {
    return &zero_[grid][layout_.at(j, k)];
  }
  [[nodiscard]] const std::uint64_t* plus(std::size_t grid, int j, int k) const {
    return &plus_[grid][layout_.at(j, k)];
  }
  [[nodiscard]] const std::uint64_t* zero(std::size_t grid, int j, int k) const {
    return &zero_[grid][layout_.at(j, k)];
  }

  /// What the vertices are made of, where that may be several materials; else nothing.
  [[nodiscard]] const MaterialPlanes* materials() const { return materials_.get(); }
  void set_materials(std::shared_ptr<const MaterialPlanes> materials) {
    materials_ = std::move(materials);
  }

  /// Of the cut edges of a family that word w owns, those whose first end is the one that
  /// the cut is measured from: of the greater material, which of one material is plus.
  [[nodiscard]] std::uint64_t measured_from_first(std::size_t f, int j, int k, int w) const {
    return materials_ ? materials_->first_is_greater(f, j, k, w)
                      : plus(families[f].first.grid, j, k)[w];
  }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(std::uint64_t) * 2 * grid_count * plus_[0].size() +
           (materials_ ? materials_->bytes() : 0);
  }
  /// The bytes that planes of this size will take, of one material.
  static std::uint64_t bytes_for(const std::array<std::int32_t, 3>& cells) {
    return std::uint64_t{2 * grid_count} * sizeof(std::uint64_t) *
           static_cast<std::uint64_t>((cells[0] + 63) / 64 + 2) *
           static_cast<std::uint64_t>(cells[1] + 2) * static_cast<std::uint64_t>(cells[2] + 2);
  }

 private:
  PlaneLayout layout_;
  std::array<std::vector<std::uint64_t>, grid_count> plus_, zero_;
  std::shared_ptr<const MaterialPlanes> materials_;
};

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
