#pragma once
/// \file
/// The plus vertices as runs along the rows of the lattice, which edges join to pieces.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "certet/context.hpp"
#include "disjoint_sets.hpp"
#include "run_cursor.hpp"
#include "vertex_index.hpp"

namespace certet::core {

/// The edges that lead from the vertices of a row to another row in the same way.
struct RowEdges {
  Grid from;
  VertexRef to;
  [[nodiscard]] constexpr bool are_long() const { return from == to.grid; }
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

/// Runs, joined by edges: by all but the long ones between two materials, and, where there
/// are several materials, by those within one.
struct RunSets {
  DisjointSets whole, regions;
};

/// Neighbouring plus vertices of a row, of one material, make a run.  Runs are numbered
/// layer by layer, row by row, even ones of a row before odd ones, from 0 on; no map is
/// needed: the number of a vertex's run follows from those of its row and the runs that
/// begin before it.
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
  [[nodiscard]] std::uint32_t run_of(const VertexIndex& v) const;
  /// Along the row at `ref` from row (j,k), by the indices of that one.
  [[nodiscard]] RunCursor cursor(VertexRef ref, int j, int k) const;

  [[nodiscard]] bool have_materials() const { return planes_.materials() != nullptr; }
  /// Of each run, where there are several.
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }

  [[nodiscard]] RunSets joined_by_edges(Context& context) const;

  [[nodiscard]] const SignPlanes& planes() const { return planes_; }

 private:
  [[nodiscard]] std::size_t at(Grid grid, int j, int k) const {
    const auto rows = static_cast<std::size_t>(planes_.cells()[1]);
    return (static_cast<std::size_t>(k) * rows + static_cast<std::size_t>(j)) * grid_count + grid;
  }
  [[nodiscard]] std::uint32_t find_starts(Grid grid, int j, int k);
  void find_materials(Grid grid, int j, int k);
  /// By the edges between its rows, or by those from it to the next layer.
  void join_layer(int k, std::int8_t layers, RunSets& sets) const;
  void join_rows(const RowEdges& edges, int j, int k, RunSets& sets) const;
  [[nodiscard]] bool are_alike(std::uint32_t a, std::uint32_t b) const {
    return !have_materials() || materials_[a] == materials_[b];
  }
  /// Those in which two runs are joined.
  DisjointSets& sets_of(std::uint32_t a, std::uint32_t b, RunSets& sets) const;

  const SignPlanes& planes_;
  /// The vertices at which runs begin, laid out as the planes are.
  std::array<std::vector<std::uint64_t>, grid_count> starts_;
  std::vector<std::uint32_t> first_;  ///< of each row; one entry more at the end
  std::vector<Material> materials_;
};

}  // namespace certet::core
