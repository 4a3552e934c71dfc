#pragma once
/// \file
/// The tetrahedra of a row of an octree's cells, 64 cells at once.

#include <array>
#include <cstddef>
#include <cstdint>

#include "lattice/graded_tets.hpp"
#include "octree.hpp"

namespace certet::core {

/// A step of -1, 0 or 1 along each axis, as a number.
constexpr std::size_t place_of_step(Coord3 step) {
  return static_cast<std::size_t>(step.x + 1 + 3 * (step.y + 1) + 9 * (step.z + 1));
}

/// Where each flag looks: for a child in its place, across its face, and whether the middles
/// of face and edge are used.
struct FlagPlaces {
  std::size_t child, face, face_middle, edge_middle;
};

inline constexpr std::array<FlagPlaces, flag_count> flag_places = [] {
  std::array<FlagPlaces, flag_count> list{};
  for (std::size_t n = 0; n < flag_count; ++n) {
    const Flag& flag = flags[n];
    list[n] = {place_of_step(flag.step_from(1, 1, 1)),
               std::size_t{2} * flag.axes[0] + (flag.up[0] ? 1 : 0),
               place_of_step(flag.step_from(1, 0, 0)), place_of_step(flag.step_from(1, 1, 0))};
  }
  return list;
}();

/// The cells of row (j,k) of a level.
class GradedRow {
 public:
  GradedRow(const Octree& octree, int level, int j, int k);

  /// How many tetrahedra those are that `for_each_in_row` tells of.
  [[nodiscard]] std::uint64_t count() const;

  /// Calls visit(w, kind, flag, cells) for each word, and each kind and flag by which any of
  /// its cells name a tetrahedron: `InGradedMesh`.  Those of the first kind at level 0 are
  /// left out, as the lattice has them.
  template <class Visit>
  void for_each_in_row(const Visit& visit) const {
    for (int w = 0; w < words_; ++w) {
      const Beside beside = look(w);
      if (beside.filled == 0) continue;
      const auto tell = [&](GradedKind kind, std::size_t flag, std::uint64_t cells) {
        if (cells != 0) visit(w, kind, flag, cells);
      };
      if (level_ == 0) for_each_pyramid(beside, tell);
      else for_each_kind(beside, tell);
    }
  }

 private:
  /// What there is at the cells of a word.
  struct Beside {
    std::uint64_t exists = 0;
    std::uint64_t filled = 0;                ///< cells with a place that no child has
    std::array<std::uint64_t, 6> across{};   ///< whether the cell across a face exists
    std::array<std::uint64_t, 27> at{};      ///< a child at a corner; at middles: is used
  };
  [[nodiscard]] Beside look(int w) const;

  /// At level 0: on the faces across which no cell exists, which few cells have.
  template <class Tell>
  void for_each_pyramid(const Beside& beside, const Tell& tell) const {
    std::array<std::uint64_t, 6> bare;
    std::uint64_t any = 0;
    for (std::size_t face = 0; face < bare.size(); ++face)
      any |= bare[face] = beside.exists & ~beside.across[face];
    if (any == 0) return;
    for (std::size_t n = 0; n < flag_count; ++n)
      if (const std::uint64_t cells = bare[flag_places[n].face]; cells != 0)
        tell(GradedKind::pyramid, n, cells & names_pyramid(flags[n]));
  }

  template <class Tell>
  void for_each_kind(const Beside& beside, const Tell& tell) const {
    for (std::size_t n = 0; n < flag_count; ++n) {
      const std::uint64_t present = beside.exists & ~beside.at[flag_places[n].child];
      if (present == 0) continue;
      const std::uint64_t whole = present & beside.across[flag_places[n].face];
      if (whole != 0) {
        const std::uint64_t face = beside.at[flag_places[n].face_middle];
        const std::uint64_t edge = beside.at[flag_places[n].edge_middle];
        if (names_tet(GradedKind::bcc, flags[n]))
          tell(GradedKind::bcc, n, whole & ~face & ~edge);
        if (names_tet(GradedKind::edge_half, flags[n]))
          tell(GradedKind::edge_half, n, whole & ~face & edge);
        if (names_tet(GradedKind::face_half, flags[n]))
          tell(GradedKind::face_half, n, whole & face & ~edge);
        tell(GradedKind::quarter, n, whole & face & edge);
      }
      if (present != whole)
        tell(GradedKind::pyramid, n, present & ~whole & names_pyramid(flags[n]));
    }
  }
  void look_at_children(int w, Beside& beside) const;
  void look_at_middles(int w, Beside& beside) const;

  /// Cells of any word for which the centre of the parent lies ahead along an axis: `IsAhead`.
  [[nodiscard]] std::uint64_t ahead(std::size_t axis, bool up) const {
    return up ? even_[axis] : ~even_[axis];
  }
  /// The face of a pyramid is cut from the corner that is nearest the centre of the parent.
  [[nodiscard]] std::uint64_t names_pyramid(const Flag& flag) const {
    return ~ahead(flag.axes[1], flag.up[1]) & ahead(flag.axes[2], flag.up[2]);
  }

  const Octree& octree_;
  int level_, j_, k_;
  int words_;
  std::array<std::uint64_t, 3> even_;  ///< cells whose index along an axis is even
};

/// The rows of cells of a level whose tetrahedra are written with those of a row of the
/// lattice: where the cells begin, or with the first row where they begin before it.
struct RowOfCells {
  bool any;
  int j, k;
};
RowOfCells row_of_cells(const Octree& octree, int level, int j, int k);

/// Calls visit(row, level, at) for each row of cells whose tetrahedra are written with a row
/// of the lattice, level by level.
template <class Visit>
void for_each_graded_row(const Octree& octree, int j, int k, const Visit& visit) {
  for (int level = 0; level <= octree.top(); ++level)
    if (const RowOfCells at = row_of_cells(octree, level, j, k); at.any)
      visit(GradedRow(octree, level, at.j, at.k), level, at);
}

/// How many tetrahedra are written with a row of the lattice besides structured ones.
std::uint64_t count_graded_tets(const Octree& octree, int j, int k);

}  // namespace certet::core
