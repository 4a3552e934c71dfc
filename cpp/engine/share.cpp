#include "share.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "certet/error.hpp"
#include "sample.hpp"

namespace certet::core {
namespace {

Window window_of(std::span<const std::int32_t> bounds, const Ranks& ranks) {
  const auto rank = static_cast<std::size_t>(ranks.rank());
  return {bounds[rank], bounds[rank + 1]};
}

std::uint64_t work_of_layer(const RowNumbers& numbers, const Lattice& lattice, std::int32_t k) {
  return core::work_of_layer(lattice, numbers.first_point(0, k + 1) - numbers.first_point(0, k),
                             numbers.first_tet(0, k + 1) - numbers.first_tet(0, k));
}

}  // namespace

std::vector<std::int32_t> balanced_bounds(std::span<const std::uint64_t> work, int ranks) {
  const auto layers = static_cast<std::int32_t>(work.size());
  if (ranks > layers)
    throw Error(ErrorCode::bad_option, "there are " + std::to_string(ranks) + " ranks, but only " +
                                           std::to_string(layers) + " layers of the lattice");
  const std::uint64_t all = std::accumulate(work.begin(), work.end(), std::uint64_t{0});
  const auto share = static_cast<double>(all) / ranks;
  std::vector<std::int32_t> bounds{0};
  double before = 0;
  std::int32_t k = 0;
  for (int rank = 1; rank < ranks; ++rank) {
    // A layer goes to the rank that the greater part of it belongs to.
    const auto half = [&] { return 0.5 * static_cast<double>(work[static_cast<std::size_t>(k)]); };
    while (k < layers && (k == bounds.back() || before + half() < share * rank))
      before += static_cast<double>(work[static_cast<std::size_t>(k++)]);
    for (const std::int32_t most = layers - (ranks - rank); k > most;)
      before -= static_cast<double>(work[static_cast<std::size_t>(--k)]);
    bounds.push_back(k);
  }
  bounds.push_back(layers);
  return bounds;
}

// To emit, to measure and to write a tetrahedron takes some ten times as long as to sample
// a cell and to decide that it is empty.
std::uint64_t work_of_layer(const Lattice& lattice, std::uint64_t points, std::uint64_t tets) {
  return 10 * (points + tets) +
         static_cast<std::uint64_t>(std::int64_t{lattice.cells[0]} * lattice.cells[1]);
}

Window balanced_window(const Domain& domain, const Lattice& lattice, const MethodFacts& method,
                       Ranks& ranks, Context& context) {
  const std::vector<std::uint64_t> equal(static_cast<std::size_t>(lattice.cells[2]), 1);
  const Window counted = window_of(balanced_bounds(equal, ranks.count()), ranks);
  const SignPlanes planes = sample(domain, lattice, widened(counted, 0, 1, lattice), method, context);
  const RowNumbers numbers(planes, lattice, counted, context);
  std::vector<std::uint64_t> work;
  for (std::int32_t k = counted.begin; k < counted.end; ++k)
    work.push_back(work_of_layer(numbers, lattice, k));
  const auto all = gather_all(ranks, std::span<const std::uint64_t>(work));
  return window_of(balanced_bounds(all, ranks.count()), ranks);
}

Window balanced_window(const RowNumbers& numbers, const Lattice& lattice, const Ranks& ranks) {
  std::vector<std::uint64_t> work;
  for (std::int32_t k = 0; k < lattice.cells[2]; ++k)
    work.push_back(work_of_layer(numbers, lattice, k));
  return window_of(balanced_bounds(work, ranks.count()), ranks);
}

Share numbered_share(RowNumbers& numbers, Window own, Ranks& ranks) {
  using Counts = std::array<std::uint64_t, 2>;
  const auto counts_up_to = [&](std::int32_t k) {
    return Counts{numbers.first_point(0, k), numbers.first_tet(0, k)};
  };
  const auto [point, tet] = counts_up_to(own.begin);
  const auto [points_end, tets_end] = counts_up_to(own.end);
  const std::vector<Counts> each =
      gather_each(ranks, Counts{points_end - point, tets_end - tet});
  Counts before{}, all{};
  for (std::size_t rank = 0; rank < each.size(); ++rank)
    for (std::size_t i = 0; i < 2; ++i) {
      if (rank < static_cast<std::size_t>(ranks.rank())) before[i] += each[rank][i];
      all[i] += each[rank][i];
    }
  numbers.start_from(before[0], before[1]);
  return {&ranks, own, false, all[0], all[1]};
}

}  // namespace certet::core
