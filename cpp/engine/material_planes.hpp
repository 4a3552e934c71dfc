#pragma once
/// \file
/// The materials of lattice vertices, as numbers and as the binary digits of these.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/domain.hpp"
#include "lattice/cell_tables.hpp"
#include "lattice/lattice_edges.hpp"
#include "plane_layout.hpp"

namespace certet::core {

/// The materials of a row of vertices: their numbers' lowest bytes side by side, and the next
/// ones a plane further, if there are so many materials.
struct MaterialRow {
  const std::uint8_t* lowest;
  std::ptrdiff_t plane;
  int bytes;

  [[nodiscard]] Material at(int i) const {
    Material material = lowest[i];
    for (int byte = 1; byte < bytes; ++byte)
      material |= Material{lowest[byte * plane + i]} << 8 * byte;
    return material;
  }
};

/// A plane for each digit, so that 64 vertices are compared with 64 others at once, and one
/// for each byte, where one vertex is asked for.  All digits of what is outside are 0, as
/// they are around the lattice.
class MaterialPlanes {
 public:
  /// For materials from 0 to `most`; all are 0 at first.
  MaterialPlanes(const PlaneLayout& layout, Material most);

  /// Materials of the row, from index 0 on.
  void set_row(Grid grid, int j, int k, std::span<const Material> row);
  void set(Grid grid, int i, int j, int k, Material material);
  /// Makes some vertices of word w the outside.
  void clear(Grid grid, int j, int k, int w, std::uint64_t vertices);
  /// To be called for each layer when its rows and those of the next are set.
  void find_parted_words(int k);

  [[nodiscard]] MaterialRow row(Grid grid, int j, int k) const {
    return {&bytes_[grid][byte_at(0, j, k)], static_cast<std::ptrdiff_t>(plane_size_), byte_count()};
  }
  [[nodiscard]] Material at(Grid grid, int i, int j, int k) const { return row(grid, j, k).at(i); }
  /// The indices of word w at which the vertices at `a` and `b` are of one material.
  [[nodiscard]] std::uint64_t alike(VertexRef a, VertexRef b, int j, int k, int w) const;
  /// Of the edges that word w owns, those whose ends are of different materials.
  [[nodiscard]] std::array<std::uint64_t, family_count> parted(int j, int k, int w) const;
  /// Of a row, the vertices of word w whose next one is of another material.
  [[nodiscard]] std::uint64_t parted_along(Grid grid, int j, int k, int w) const;
  /// Of those of a family, those whose first end is of the greater material.
  [[nodiscard]] std::uint64_t first_is_greater(std::size_t f, int j, int k, int w) const;
  /// Of the cells that word w owns, those whose vertices are all of one material.
  [[nodiscard]] std::uint64_t uniform_cells(int j, int k, int w) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Where the digits of word w of a row begin.
  [[nodiscard]] std::size_t begin(int j, int k, int w = 0) const {
    return (layout_.at(j, k) + static_cast<std::size_t>(w)) * static_cast<std::size_t>(digits_);
  }
  [[nodiscard]] int byte_count() const { return (digits_ + 7) / 8; }
  /// Where a vertex has its lowest byte; there is a rim of one vertex all around.
  [[nodiscard]] std::size_t byte_at(int i, int j, int k) const {
    const auto& cells = layout_.cells();
    const auto layer = static_cast<std::size_t>(cells[1] + 2);
    const auto rows = static_cast<std::size_t>(k + 1 - layout_.window().begin) * layer +
                      static_cast<std::size_t>(j + 1);
    return rows * static_cast<std::size_t>(cells[0] + 2) + static_cast<std::size_t>(i + 1);
  }
  void set_byte(Grid grid, std::size_t at, Material material) {
    for (int byte = 0; byte < byte_count(); ++byte)
      bytes_[grid][static_cast<std::size_t>(byte) * plane_size_ + at] =
          static_cast<std::uint8_t>(material >> 8 * byte);
  }
  /// A digit of the vertices at `ref` from the indices of word w.
  [[nodiscard]] std::uint64_t digit(int d, VertexRef ref, int j, int k, int w) const {
    const std::uint64_t* const row = &words_[ref.grid][begin(j + ref.shift.y, k + ref.shift.z)];
    return shifted(row + d, w, ref.shift.x, digits_);
  }
  /// The digits of the rows of some vertices, from those of row (j,k).
  template <std::size_t count>
  [[nodiscard]] std::array<const std::uint64_t*, count> rows_at(
      const std::array<VertexRef, count>& vertices, int j, int k) const {
    std::array<const std::uint64_t*, count> rows;
    for (std::size_t n = 0; n < count; ++n)
      rows[n] = &words_[vertices[n].grid][begin(j + vertices[n].shift.y, k + vertices[n].shift.z)];
    return rows;
  }
  /// Whether word w of a row in the window owns an edge with two materials.
  [[nodiscard]] bool is_parted(int j, int k, int w) const {
    return parted_words_[layout_.at(j, k) + static_cast<std::size_t>(w)] != 0;
  }
  [[nodiscard]] std::array<std::uint64_t, family_count> compare(int j, int k, int w) const;

  PlaneLayout layout_;
  int digits_;
  std::array<std::vector<std::uint64_t>, grid_count> words_;  ///< the lowest digits first
  std::vector<std::uint8_t> parted_words_;
  std::size_t plane_size_;  ///< of bytes
  std::array<std::vector<std::uint8_t>, grid_count> bytes_;
};

}  // namespace certet::core
