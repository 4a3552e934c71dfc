#pragma once
/// \file
/// The materials of lattice vertices, as the binary digits of their numbers.

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

/// A plane for each digit, so that 64 vertices are compared with 64 others at once.  All
/// digits of what is outside are 0, as they are around the lattice.
class MaterialPlanes {
 public:
  /// For materials from 0 to `most`; all are 0 at first.
  MaterialPlanes(const PlaneLayout& layout, Material most);

  /// Materials of the row, from index 0 on.
  void set_row(Grid grid, int j, int k, std::span<const Material> row);
  void set(Grid grid, int i, int j, int k, Material material);
  /// To be called for each layer when its rows and those of the next are set.
  void find_parted_words(int k);

  [[nodiscard]] Material at(Grid grid, int i, int j, int k) const;
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
  [[nodiscard]] const std::uint64_t* row(std::size_t digit, VertexRef ref, int j, int k) const {
    return &planes_[digit][ref.grid][layout_.at(j + ref.shift.y, k + ref.shift.z)];
  }
  /// Whether word w of a row in the window owns an edge with two materials.
  [[nodiscard]] bool is_parted(int j, int k, int w) const {
    return parted_words_[layout_.at(j, k) + static_cast<std::size_t>(w)] != 0;
  }
  [[nodiscard]] std::array<std::uint64_t, family_count> compare(int j, int k, int w) const;

  PlaneLayout layout_;
  std::vector<std::array<std::vector<std::uint64_t>, grid_count>> planes_;  ///< by digits, the lowest first
  std::vector<std::uint8_t> parted_words_;
};

}  // namespace certet::core
