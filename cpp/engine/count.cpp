#include "count.hpp"

#include <numeric>

#include "cell_word.hpp"
#include "graded_rows.hpp"
#include "layer_loop.hpp"
#include "material_cells.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

std::uint64_t count_tets(const SignPlanes& planes, const GradedCells* graded, int j, int k) {
  const SignRows signs(planes, j, k);
  std::uint64_t count = 0;
  for (int w = 0; w < planes.words(); ++w) {
    const CellWord word(signs, w);
    if (word.any_plus == 0) continue;
    OfCases structured;
    if (graded != nullptr) structured = graded->structured(j, k, w);
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      const StencilCounts counts = word.counts(cell.corner[c]);
      // The surface is where no tetrahedron of the lattice is left out.
      const std::uint64_t one =
          graded == nullptr ? counts.one : counts.one & structured[c];
      count += static_cast<std::uint64_t>(std::popcount(one) + std::popcount(counts.two) +
                                          std::popcount(counts.three));
    }
  }
  return count;
}

/// The same where several materials meet.
std::uint64_t count_material_tets(const SignPlanes& planes, const GradedCells* graded, int j,
                                  int k) {
  const MaterialCells cells(planes, j, k);
  std::uint64_t count = 0;
  for (int w = 0; w < planes.words(); ++w) {
    const auto [any, whole] = cells.kinds(w);
    if (graded == nullptr) {
      count += cell_tet_count * static_cast<std::uint64_t>(std::popcount(whole));
      for_each_bit(any & ~whole, [&](int b) { count += cells.count_tets(64 * w + b); });
      continue;
    }
    const OfCases structured = graded->structured(j, k, w);
    for (const std::uint64_t of_case : structured)
      count += static_cast<std::uint64_t>(std::popcount(whole & of_case));
    for_each_bit(any & ~whole, [&](int b) {
      cells.for_each_tet(64 * w + b, [&](std::size_t c, auto...) {
        if ((structured[c] >> b & 1) != 0) ++count;
      });
    });
  }
  return count;
}

}  // namespace

RowNumbers::RowNumbers(const SignPlanes& planes, const Lattice& lattice, Window window,
                       Context& context, const GradedCells* graded)
    : graded_(graded), window_(window), rows_(static_cast<std::size_t>(lattice.cells[1])) {
  const Window counted = widened(window, 0, 1, lattice);
  const std::size_t rows = rows_ * static_cast<std::size_t>(counted.layers());
  points_.resize(rows + 1);
  tets_.resize(rows + 1);
  for_each_layer(context, Stage::count, counted, [&](std::int32_t k) {
    RowRanks ranks;
    for (int j = 0; j < lattice.cells[1]; ++j) {
      ranks.compute(planes, j, k, graded);
      points_[at(j, k)] = ranks.count();
      if (!window_.contains(k)) continue;
      tets_[at(j, k)] = planes.materials() == nullptr
                            ? count_tets(planes, graded, j, k)
                            : count_material_tets(planes, graded, j, k);
      if (graded != nullptr) tets_[at(j, k)] += count_graded_tets(graded->octree(), j, k);
    }
  });
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
