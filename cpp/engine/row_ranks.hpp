#pragma once
/// \file
/// Numbers for the points of a row, without any map: a point's number follows
/// from its row, its kind and its rank among the points of that kind.
/// Picture: cpp/docs/pictures/ranks.svg.

#include <bit>
#include <cstdint>
#include <vector>

#include "graded_cells.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// For one row (j,k) and each kind of point, which indices own a point, and how
/// many points of the row come before.  A corner is a point if its sign is plus
/// or zero; an edge owns a cut if its ends have opposite signs or, where several
/// materials meet, none of them is zero and they are of different materials.
class RowRanks {
 public:
  /// Rows outside the lattice, or the window of the planes, are allowed; they own
  /// nothing.  Where the mesh is graded only corners that it uses are points.
  void compute(const SignPlanes& planes, int j, int k, const GradedCells* graded = nullptr);

  [[nodiscard]] int words() const { return words_; }
  [[nodiscard]] std::uint64_t mask(std::size_t kind, int w) const { return at(kind, w).mask; }
  /// Rank of the point of this kind owned by bit b of word w.
  [[nodiscard]] std::uint32_t rank(std::size_t kind, int w, int b) const {
    const Entry& e = at(kind, w);
    return e.before + static_cast<std::uint32_t>(std::popcount(e.mask & below(b)));
  }
  /// All points of the row, and the corners among them.
  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] std::uint32_t corners() const { return corners_; }

 private:
  struct Entry {
    std::uint64_t mask;
    std::uint32_t before;
  };
  [[nodiscard]] const Entry& at(std::size_t kind, int w) const {
    return entries_[static_cast<std::size_t>(w) * kind_count + kind];
  }

  void number_entries();

  int words_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t corners_ = 0;
  std::vector<Entry> entries_;
};

/// Calls visit(b) for every set bit of a word.
template <class Visit>
void for_each_bit(std::uint64_t word, const Visit& visit) {
  for (; word != 0; word &= word - 1) visit(std::countr_zero(word));
}

}  // namespace certet::core
