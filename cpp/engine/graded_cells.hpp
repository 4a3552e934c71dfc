#pragma once
/// \file
/// What a graded mesh has of the lattice.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "lattice/cell_tables.hpp"
#include "octree.hpp"
#include "plane_layout.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// A word for each case of structured tetrahedra.
using OfCases = std::array<std::uint64_t, cell_tet_count>;

/// The octree of a mesh, and which vertices of the lattice it uses.
class GradedCells {
 public:
  GradedCells(const SignPlanes& planes, const Lattice& lattice, const Grading& grading,
              Context& context);

  [[nodiscard]] const Octree& octree() const { return octree_; }

  /// Of word w of a row: which vertices inside or on the surface the mesh uses.  Odd ones are
  /// the centres of cells of level 0, the others corners and centres of cells of any level.
  [[nodiscard]] std::uint64_t used(Grid grid, int j, int k, int w) const {
    return grid == odd ? octree_.cells(0, j, k)[w] : even_.row(j, k)[w];
  }
  /// Of the structured tetrahedra of each case, those of word w that the mesh has: both cells in
  /// which one lies exist.
  [[nodiscard]] OfCases structured(int j, int k, int w) const;

  /// How many points and tetrahedra of a row of the lattice the mesh has not: those are inside,
  /// and within cells that do not exist.
  [[nodiscard]] std::uint64_t points_left_out(const SignPlanes& planes, int j, int k) const;
  [[nodiscard]] std::uint64_t tets_left_out(int j, int k) const;

  /// Of a row of the lattice: how many points come before an even vertex that is used.
  class EvenRanks {
   public:
    EvenRanks(const std::uint64_t* used, const std::uint32_t* before)
        : used_(used), before_(before) {}
    [[nodiscard]] std::uint32_t operator[](int i) const {
      const int w = i >> 6;
      return before_[w] + static_cast<std::uint32_t>(std::popcount(used_[w] & below(i & 63)));
    }

   private:
    const std::uint64_t* used_;
    const std::uint32_t* before_;
  };
  [[nodiscard]] EvenRanks ranks(int j, int k) const {
    return {even_.words(j, k), &before_[word(j, k, 0)]};
  }
  /// Tetrahedra of a layer use points of no more layers behind it.
  [[nodiscard]] std::int32_t layers_behind() const;

  [[nodiscard]] std::uint64_t bytes() const {
    return octree_.bytes() + even_.bytes() + sizeof(std::uint32_t) * before_.size();
  }

 private:
  [[nodiscard]] std::size_t word(int j, int k, int w) const {
    const LevelGrid& grid = even_.grid();
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.cells[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(grid.words()) +
           static_cast<std::size_t>(w);
  }
  void find_even(const SignPlanes& planes, int j, int k);

  Octree octree_;
  CellPlane even_;                     ///< even vertices that are used
  std::vector<std::uint32_t> before_;  ///< in their row, before each word of these
};

}  // namespace certet::core
