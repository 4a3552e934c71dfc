#pragma once
/// \file
/// The plus vertices as runs along the rows of the lattice, which edges join to pieces.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "disjoint_sets.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// The edges that lead from the vertices of a row to another row in the same way.
struct RowEdges {
  Grid from;
  VertexRef to;
};

/// All of them, once each: to rows that come later, or that are of an earlier grid.
inline constexpr auto edges_between_rows = [] {
  constexpr auto is_taken = [](Grid from, const VertexRef& to) {
    const auto [x, y, z] = to.shift;
    return z > 0 || (z == 0 && (y > 0 || (y == 0 && to.grid < from)));
  };
  constexpr std::size_t count = [=] {
    std::size_t taken = 0;
    for (const Grid grid : grids)
      for (std::size_t d = 0; d < tiling.directions.size(); ++d)
        taken += is_taken(grid, neighbor(grid, d)) ? 1 : 0;
    return taken;
  }();
  std::array<RowEdges, count> list{};
  std::size_t next = 0;
  for (const Grid grid : grids)
    for (std::size_t d = 0; d < tiling.directions.size(); ++d)
      if (is_taken(grid, neighbor(grid, d))) list[next++] = {grid, neighbor(grid, d)};
  return list;
}();

/// The bits at which runs of a row begin, seen from a word of it and the one before.
constexpr std::uint64_t run_starts(std::uint64_t word, std::uint64_t before) {
  return word & ~(word << 1 | before >> 63);
}

/// Neighbouring plus vertices of a row make a run.  Runs are numbered layer by layer, row
/// by row, even ones of a row before odd ones, from 0 on; no map is needed: the number of a
/// vertex's run follows from those of its row and the signs before it.
class PlusRuns {
 public:
  /// \throws Error `too_large` if 32 bits do not count them, `cancelled`.
  PlusRuns(const SignPlanes& planes, Context& context);

  [[nodiscard]] std::uint32_t size() const { return first_.back(); }
  [[nodiscard]] std::uint32_t first(Grid grid, int j, int k) const { return first_[at(grid, j, k)]; }
  [[nodiscard]] std::uint32_t end(Grid grid, int j, int k) const {
    return first_[at(grid, j, k) + 1];
  }
  /// The run of a plus vertex.
  [[nodiscard]] std::uint32_t run_of(Grid grid, int i, int j, int k) const;

  /// Joins the runs that edges of the lattice join.
  [[nodiscard]] DisjointSets joined_by_edges(Context& context) const;

  [[nodiscard]] const SignPlanes& planes() const { return planes_; }

 private:
  [[nodiscard]] std::size_t at(Grid grid, int j, int k) const {
    const auto rows = static_cast<std::size_t>(planes_.cells()[1]);
    return (static_cast<std::size_t>(k) * rows + static_cast<std::size_t>(j)) * grid_count + grid;
  }
  /// By the edges between its rows, or by those from it to the next layer.
  void join_layer(int k, std::int8_t layers, DisjointSets& sets) const;
  void join_rows(const RowEdges& edges, int j, int k, DisjointSets& sets) const;

  const SignPlanes& planes_;
  std::vector<std::uint32_t> first_;  ///< of each row; one entry more at the end
};

/// Goes along a row, from its first word on, and numbers the runs on the way.
class RunCursor {
 public:
  /// As seen from vertices whose index is `shift` smaller.
  RunCursor(const std::uint64_t* row, int shift, std::uint32_t first)
      : row_(row), shift_(shift), before_(shift > 0 ? row[0] << 63 : 0),
        next_(first + static_cast<std::uint32_t>(before_ >> 63)) {}

  /// The plus vertices of the next word.
  std::uint64_t next(int w) {
    next_ += static_cast<std::uint32_t>(std::popcount(starts_));
    const std::uint64_t word = shifted(row_, w, shift_);
    starts_ = run_starts(word, before_);
    before_ = word;
    return word;
  }
  /// The run of a plus vertex of the word.
  [[nodiscard]] std::uint32_t run(int b) const {
    return next_ + static_cast<std::uint32_t>(std::popcount(starts_ << (63 - b))) - 1;
  }

 private:
  const std::uint64_t* row_;
  int shift_;
  std::uint64_t before_, starts_ = 0;
  std::uint32_t next_;  ///< the first run that begins in the word or later
};

}  // namespace certet::core
