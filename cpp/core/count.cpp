#include "count.hpp"

#include <numeric>

#include "cell_tables.hpp"
#include "certet/stencil.hpp"
#include "parallel.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// The lengths of 64 stencils at once.  A stencil has one tetrahedron if any
/// corner is plus, one more if there is also a minus and a second plus, and a
/// third if, besides, no corner is zero.
struct StencilCounts {
  std::uint64_t one, two, three;
};

constexpr StencilCounts stencil_counts(const std::array<SignWord, 4>& corner) {
  std::uint64_t plus = 0;
  std::uint64_t two_plus = 0;
  std::uint64_t minus = 0;
  std::uint64_t zero = 0;
  for (const SignWord& c : corner) {
    two_plus |= plus & c.plus;
    plus |= c.plus;
    minus |= c.minus();
    zero |= c.zero;
  }
  const std::uint64_t split = two_plus & minus;
  return {plus, split, split & ~zero};
}

/// The rule above is the stencil table's.
static_assert([] {
  for (int index = 0; index < pattern_count; ++index) {
    std::array<SignWord, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Sign s = pattern_signs(index)[i];
      corner[i] = {s == Sign::plus ? 1u : 0u, s == Sign::on_surface ? 1u : 0u};
    }
    const StencilCounts counts = stencil_counts(corner);
    if ((counts.one & 1) + (counts.two & 1) + (counts.three & 1) != unstructured_tets(pattern_signs(index)).count)
      return false;
  }
  return true;
}());

std::uint64_t count_tets(const SignPlanes& planes, int j, int k) {
  const SignRows signs(planes, j, k);
  std::uint64_t count = 0;
  for (int w = 0; w < planes.words(); ++w) {
    std::array<SignWord, cell_vertex_count> vertex;
    std::uint64_t any_plus = 0;
    for (std::size_t v = 0; v < cell_vertex_count; ++v) {
      vertex[v] = signs.at(cell.vertices[v], w);
      any_plus |= vertex[v].plus;
    }
    if (any_plus == 0) continue;
    for (const auto& corner : cell.corner) {
      const StencilCounts counts = stencil_counts(
          {vertex[corner[0]], vertex[corner[1]], vertex[corner[2]], vertex[corner[3]]});
      count += static_cast<std::uint64_t>(std::popcount(counts.one) + std::popcount(counts.two) +
                                          std::popcount(counts.three));
    }
  }
  return count;
}

}  // namespace

RowNumbers count_rows(const SignPlanes& planes, Context& context) {
  const auto rows = static_cast<std::size_t>(planes.cells()[1]);
  const auto layers = static_cast<std::size_t>(planes.cells()[2]);
  RowNumbers numbers{std::vector<std::uint64_t>(rows * layers + 1),
                     std::vector<std::uint64_t>(rows * layers + 1)};
  parallel_for(context, Stage::count, static_cast<std::int64_t>(layers), [&](std::int64_t k) {
    RowRanks ranks;
    for (std::size_t j = 0; j < rows; ++j) {
      const std::size_t row = static_cast<std::size_t>(k) * rows + j;
      ranks.compute(planes, static_cast<int>(j), static_cast<int>(k));
      numbers.first_point[row] = ranks.count();
      numbers.first_tet[row] = count_tets(planes, static_cast<int>(j), static_cast<int>(k));
    }
  });
  for (auto* counts : {&numbers.first_point, &numbers.first_tet})
    std::exclusive_scan(counts->begin(), counts->end(), counts->begin(), std::uint64_t{0});
  return numbers;
}

}  // namespace certet::core
