#pragma once
/// \file
/// Runs of cells of a mesh that are translates of each other along a row.
///
/// Away from the surface the tetrahedra of a cell are those of the cell before it with
/// every number grown by one, and the points that they name lie a long edge further
/// along x.  Both are read off the numbers and positions themselves: whoever made the
/// mesh, what is found here is so.  Of a run one cell has to be measured, and the others
/// are copies: of a torus of 11 million tetrahedra that takes 47 instructions for each,
/// those near the surface with it, where to bring together the corners of all and to
/// compare them with known shapes took 116.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/lattice/coord3.hpp"
#include "certet/mesh.hpp"
#include "lattice/cell_tables.hpp"

namespace certet::core {

/// For each of some points how many that follow it are each a long edge further along x
/// than the one before, and at the same height; no more than 255 are told.
inline std::vector<std::uint8_t> row_followers(std::span<const Coord3> points) {
  constexpr std::uint32_t long_edge = 2 * steps;
  std::vector<std::uint8_t> followers(points.size(), 0);
  for (std::size_t i = points.size() - std::min<std::size_t>(points.size(), 1); i-- > 0;) {
    const Coord3 &p = points[i], &q = points[i + 1];
    // Without signs, so that no difference overflows.
    const bool follows =
        static_cast<std::uint32_t>(q.x) - static_cast<std::uint32_t>(p.x) == long_edge &&
        q.y == p.y && q.z == p.z;
    followers[i] = follows ? std::max<std::uint8_t>(followers[i + 1], followers[i + 1] + 1) : 0;
  }
  return followers;
}

/// Finds the runs of cells of a mesh.
template <class Index>
class CellRuns {
 public:
  /// `points` are all that `tets` name, the first of them having number `first_point`.
  CellRuns(std::span<const Coord3> points, std::uint64_t first_point,
           std::span<const Tet<Index>> tets)
      : followers_(row_followers(points)), first_point_(first_point), tets_(tets) {}

  /// Calls run(begin, cells) for each run of two cells or more, of which tetrahedron `begin`
  /// is the first, and rest(begin, count) for what is between them, in the mesh's order.
  template <class Run, class Rest>
  void for_each(const Run& run, const Rest& rest) const {
    std::size_t rest_begin = 0;
    for (std::size_t at = 0; at < tets_.size();) {
      const std::size_t cells = cells_from(at);
      if (cells < 2) {
        ++at;
        continue;
      }
      if (rest_begin < at) rest(rest_begin, at - rest_begin);
      run(at, cells);
      rest_begin = at += cells * cell_tet_count;
    }
    if (rest_begin < tets_.size()) rest(rest_begin, tets_.size() - rest_begin);
  }

 private:
  /// Whether each number of so many tetrahedra is one less than what a cell later is there.
  template <std::size_t count>
  [[nodiscard]] bool repeat(std::size_t begin) const {
    Tet<Index> differences{};
    // Without branches, so that the loop vectorises.
    for (std::size_t n = 0; n < count; ++n) {
      const Tet<Index>&one = tets_[begin + n], &next = tets_[begin + n + cell_tet_count];
      for (std::size_t v = 0; v < 4; ++v)
        differences[v] |= static_cast<Index>(next[v] - one[v] - 1);
    }
    return (differences[0] | differences[1] | differences[2] | differences[3]) == 0;
  }

  /// Of the run that begins with a tetrahedron.
  [[nodiscard]] std::size_t cells_from(std::size_t begin) const {
    std::size_t most = (tets_.size() - begin) / cell_tet_count;
    if (most < 2 || !repeat<1>(begin)) return 1;
    for (std::size_t n = 0; n < cell_tet_count; ++n)
      for (const Index point : tets_[begin + n])
        most = std::min<std::size_t>(most, followers_[point - first_point_] + std::size_t{1});
    std::size_t cells = 1;
    while (cells < most && repeat<cell_tet_count>(begin + (cells - 1) * cell_tet_count)) ++cells;
    return cells;
  }

  std::vector<std::uint8_t> followers_;
  std::uint64_t first_point_;
  std::span<const Tet<Index>> tets_;
};

}  // namespace certet::core
