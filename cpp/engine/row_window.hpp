#pragma once
/// \file
/// Four neighbouring rows at a time.

#include <array>
#include <utility>

#include "row_ranks.hpp"

namespace certet::core {

/// The ranks of rows (j..j+1, k..k+1), moved along j: points of a cell of row (j,k)
/// are owned by these rows alone.  A step along j computes two and keeps two.
class RowWindow {
 public:
  RowWindow(const SignPlanes& planes, int j, int k, const GradedCells* graded = nullptr)
      : planes_(planes), graded_(graded), j_(j), k_(k) {
    for (std::size_t y = 0; y < 2; ++y) compute(y);
  }

  [[nodiscard]] int j() const { return j_; }
  [[nodiscard]] int k() const { return k_; }
  /// The row at (j + y, k + z); y and z are 0 or 1.
  [[nodiscard]] const RowRanks& row(std::size_t y, std::size_t z) const { return rows_[y][z]; }

  void next() {
    ++j_;
    std::swap(rows_[0], rows_[1]);
    compute(1);
  }

 private:
  void compute(std::size_t y) {
    for (std::size_t z = 0; z < 2; ++z)
      rows_[y][z].compute(planes_, j_ + static_cast<int>(y), k_ + static_cast<int>(z), graded_);
  }

  const SignPlanes& planes_;
  const GradedCells* graded_;
  int j_, k_;
  std::array<std::array<RowRanks, 2>, 2> rows_;
};

/// Index `b` of word `w`, moved by -1, 0 or 1.
struct WordBit {
  int w, b;
  [[nodiscard]] WordBit moved(int shift) const {
    const int i = 64 * w + b + shift;
    return {i >> 6, i & 63};
  }
};

}  // namespace certet::core
