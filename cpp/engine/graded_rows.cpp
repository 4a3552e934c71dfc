#include "graded_rows.hpp"

#include <bit>

namespace certet::core {

GradedRow::GradedRow(const Octree& octree, int level, int j, int k)
    : octree_(octree), level_(level), j_(j), k_(k), words_(octree.grid(level).words()) {
  constexpr std::uint64_t every_other = 0x5555555555555555;
  const auto& first = octree.grid(level).first;
  const auto all_if = [](bool condition) { return condition ? ~std::uint64_t{0} : 0; };
  even_ = {(first[0] & 1) == 0 ? every_other : ~every_other, all_if(((first[1] + j) & 1) == 0),
           all_if(((first[2] + k) & 1) == 0)};
}

GradedRow::Beside GradedRow::look(int w) const {
  Beside beside;
  beside.exists = beside.filled = octree_.cells(level_, j_, k_)[w];
  if (beside.exists == 0) return beside;
  if (level_ > 0) look_at_children(w, beside);
  if (beside.filled == 0) return beside;
  const auto row = [this](int y, int z) { return octree_.cells(level_, j_ + y, k_ + z); };
  beside.across = {row(0, 0).shifted(w, -1), row(0, 0).shifted(w, 1), row(-1, 0)[w],
                   row(1, 0)[w],             row(0, -1)[w],           row(0, 1)[w]};
  if (level_ > 0) look_at_middles(w, beside);
  return beside;
}

void GradedRow::look_at_children(int w, Beside& beside) const {
  const LevelGrid& grid = octree_.grid(level_ - 1);
  std::uint64_t all = ~std::uint64_t{0};
  for (const int z : {0, 1})
    for (const int y : {0, 1}) {
      const BitRow row = octree_.cells(level_ - 1, 2 * j_ - grid.is_upper(1) + y,
                                       2 * k_ - grid.is_upper(2) + z);
      for (const int x : {0, 1}) {
        const int shift = x - grid.is_upper(0);
        all &= beside.at[place_of_step({2 * x - 1, 2 * y - 1, 2 * z - 1})] =
            every_second(row.shifted(2 * w, shift), row.shifted(2 * w + 1, shift));
      }
    }
  beside.filled = beside.exists & ~all;
}

void GradedRow::look_at_middles(int w, Beside& beside) const {
  const LevelGrid& grid = octree_.grid(level_ - 1);
  for (const int z : {-1, 0, 1})
    for (const int y : {-1, 0, 1}) {
      const BitRow row = octree_.corners(level_ - 1, 2 * j_ - grid.is_upper(1) + y + 1,
                                         2 * k_ - grid.is_upper(2) + z + 1);
      for (const int x : {-1, 0, 1}) {
        const int sides = x * x + y * y + z * z;  // 1 at a face, 2 at an edge
        if (sides != 1 && sides != 2) continue;
        const int shift = x + 1 - grid.is_upper(0);
        beside.at[place_of_step({x, y, z})] =
            every_second(row.shifted(2 * w, shift), row.shifted(2 * w + 1, shift));
      }
    }
}

RowOfCells row_of_cells(const Octree& octree, int level, int j, int k) {
  const LevelGrid& fine = octree.grid(0);
  const LevelGrid& grid = octree.grid(level);
  const auto begins = [&](int index, std::size_t axis) {
    return index == 0 || ((index + fine.first[axis]) & ((1 << level) - 1)) == 0;
  };
  const auto cell = [&](int index, std::size_t axis) {
    return ((index + fine.first[axis]) >> level) - grid.first[axis];
  };
  return {begins(j, 1) && begins(k, 2), cell(j, 1), cell(k, 2)};
}

std::uint64_t GradedRow::count() const {
  int count = 0;
  for (int w = 0; level_ == 0 && w < words_; ++w) {
    const Beside beside = look(w);
    // On each square that no cell lies behind stand the two halves of a pyramid.
    for (const std::uint64_t across : beside.across) count += 2 * std::popcount(beside.exists & ~across);
  }
  if (level_ > 0)
    for_each_in_row([&](int, GradedKind, std::size_t, std::uint64_t cells) {
      count += std::popcount(cells);
    });
  return static_cast<std::uint64_t>(count);
}

std::uint64_t count_graded_tets(const Octree& octree, int j, int k) {
  std::uint64_t count = 0;
  for_each_graded_row(octree, j, k, [&](const GradedRow& row, int, const RowOfCells&) {
    count += row.count();
  });
  return count;
}

}  // namespace certet::core
