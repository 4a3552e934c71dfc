#include "count.hpp"

#include <numeric>

#include "cell_word.hpp"
#include "graded_rows.hpp"
#include "layer_loop.hpp"
#include "material_cells.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

std::uint64_t count_tets(const SignPlanes& planes, int j, int k) {
  const SignRows signs(planes, j, k);
  std::uint64_t count = 0;
  for (int w = 0; w < planes.words(); ++w) {
    const CellWord word(signs, w);
    if (word.any_plus == 0) continue;
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      const StencilCounts counts = word.counts(cell.corner[c]);
      count += static_cast<std::uint64_t>(std::popcount(counts.one) + std::popcount(counts.two) +
                                          std::popcount(counts.three));
    }
  }
  return count;
}

/// The same where several materials meet.
std::uint64_t count_material_tets(const SignPlanes& planes, int j, int k) {
  const MaterialCells cells(planes, j, k);
  std::uint64_t count = 0;
  for (int w = 0; w < planes.words(); ++w) {
    const auto [any, whole] = cells.kinds(w);
    count += cell_tet_count * static_cast<std::uint64_t>(std::popcount(whole));
    for_each_bit(any & ~whole, [&](int b) { count += cells.count_tets(64 * w + b); });
  }
  return count;
}

}  // namespace

RowNumbers::RowNumbers(const SignPlanes& planes, const Lattice& lattice, Window window,
                       Context& context)
    : window_(window), rows_(static_cast<std::size_t>(lattice.cells[1])) {
  const Window counted = widened(window, 0, 1, lattice);
  const std::size_t rows = rows_ * static_cast<std::size_t>(counted.layers());
  points_.resize(rows + 1);
  tets_.resize(rows + 1);
  for_each_layer(context, Stage::count, counted, [&](std::int32_t k) {
    RowRanks ranks;
    for (int j = 0; j < lattice.cells[1]; ++j) {
      ranks.compute(planes, j, k);
      points_[at(j, k)] = ranks.count();
      if (!window_.contains(k)) continue;
      tets_[at(j, k)] = planes.materials() == nullptr ? count_tets(planes, j, k)
                                                      : count_material_tets(planes, j, k);
    }
  });
  number_rows();
}

RowNumbers::RowNumbers(const RowNumbers& uniform, const SignPlanes& planes, const Lattice& lattice,
                       Context& context, const GradedCells& graded)
    : graded_(&graded), window_(uniform.window_), rows_(uniform.rows_),
      points_(uniform.points_.size()), tets_(uniform.tets_.size()) {
  const auto of_row = [](const std::vector<std::uint64_t>& numbers, std::size_t n) {
    return numbers[n + 1] - numbers[n];
  };
  for_each_layer(context, Stage::count, whole(lattice), [&](std::int32_t k) {
    for (int j = 0; j < lattice.cells[1]; ++j) {
      const std::size_t n = at(j, k);
      points_[n] = of_row(uniform.points_, n) - graded.points_left_out(planes, j, k);
      tets_[n] = of_row(uniform.tets_, n) - graded.tets_left_out(j, k) +
                 count_graded_tets(graded.octree(), j, k);
    }
  });
  number_rows();
}

void RowNumbers::number_rows() {
  for (auto* counts : {&points_, &tets_})
    std::exclusive_scan(counts->begin(), counts->end(), counts->begin(), std::uint64_t{0});
}

void RowNumbers::start_from(std::uint64_t point, std::uint64_t tet) {
  const std::uint64_t points = point - points_.front();
  const std::uint64_t tets = tet - tets_.front();
  for (std::uint64_t& number : points_) number += points;
  for (std::uint64_t& number : tets_) number += tets;
}

}  // namespace certet::core
