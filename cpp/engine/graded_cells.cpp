#include "graded_cells.hpp"

#include "graded_rows.hpp"
#include "layer_loop.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// The even vertices of a row that are corners or centres of cells of a level above 0.
void add_vertices(const Octree& octree, int level, int j, int k, std::uint64_t* row) {
  const LevelGrid& fine = octree.grid(0);
  const LevelGrid& grid = octree.grid(level);
  const auto add = [&](std::uint64_t bits, int w, int from) {
    for_each_bit(bits, [&](int b) {
      const int x = ((grid.first[0] + 64 * w + b) << level) + from - fine.first[0];
      if (x >= 0 && x < fine.cells[0]) row[x >> 6] |= std::uint64_t{1} << (x & 63);
    });
  };
  const int side = 1 << level;
  const int y = j + fine.first[1], z = k + fine.first[2];
  const int cell_j = (y >> level) - grid.first[1], cell_k = (z >> level) - grid.first[2];
  // Cells of the top level all exist, and so does one around each of their corners.
  const auto corners = [&](int w) {
    return level == octree.top() ? ~std::uint64_t{0} : octree.corners(level, cell_j, cell_k)[w];
  };
  const bool at_corners = ((y | z) & (side - 1)) == 0;
  const bool at_centres = (y & (side - 1)) == side / 2 && (z & (side - 1)) == side / 2;
  for (int w = 0; w < grid.words(); ++w) {
    if (at_corners) add(corners(w), w, 0);
    if (at_centres) add(octree.cells(level, cell_j, cell_k)[w], w, side / 2);
  }
}

/// The centres of the two cells in which a structured tetrahedron of each case lies, among the
/// vertices of a cell.
constexpr auto centres_of_cases = [] {
  std::array<std::array<std::uint8_t, 2>, cell_tet_count> table{};
  for (std::size_t c = 0; c < cell_tet_count; ++c)
    for (std::size_t n = 0; const std::uint8_t corner : cell.corner[c])
      if (cell.vertices[corner].grid == odd && n < 2) table[c][n++] = corner;
  return table;
}();

}  // namespace

GradedCells::GradedCells(const SignPlanes& planes, const Lattice& lattice,
                         const Grading& grading, Context& context)
    : octree_(planes, lattice, grading, context), even_(LevelGrid(lattice)),
      before_(static_cast<std::size_t>(planes.words()) *
              static_cast<std::size_t>(lattice.cells[1]) *
              static_cast<std::size_t>(lattice.cells[2])) {
  for_each_layer(context, Stage::count, whole(lattice), [&](std::int32_t k) {
    for (int j = 0; j < lattice.cells[1]; ++j) find_even(planes, j, k);
  });
}

void GradedCells::find_even(const SignPlanes& planes, int j, int k) {
  std::uint64_t* const row = even_.words(j, k);
  const BitRow corners = octree_.corners(0, j, k);
  for (int w = 0; w < planes.words(); ++w) row[w] = corners[w];
  for (int level = 1; level <= octree_.top(); ++level) add_vertices(octree_, level, j, k, row);
  std::uint32_t before = 0;
  for (int w = 0; w < planes.words(); ++w) {
    row[w] &= planes.plus(even, j, k)[w] | planes.zero(even, j, k)[w];
    before_[word(j, k, w)] = before;
    before += static_cast<std::uint32_t>(std::popcount(row[w]));
  }
}

OfCases GradedCells::structured(int j, int k, int w) const {
  std::array<std::uint64_t, cell_vertex_count> exists{};
  for (std::size_t v = 0; v < cell_vertex_count; ++v)
    if (const auto& [grid, shift] = cell.vertices[v]; grid == odd)
      exists[v] = octree_.cells(0, j + shift.y, k + shift.z).shifted(w, shift.x);
  OfCases both;
  for (std::size_t c = 0; c < cell_tet_count; ++c)
    both[c] = exists[centres_of_cases[c][0]] & exists[centres_of_cases[c][1]];
  return both;
}

std::uint64_t GradedCells::points_left_out(const SignPlanes& planes, int j, int k) const {
  int count = 0;
  for (const Grid grid : grids) {
    const std::uint64_t* const plus = planes.plus(grid, j, k);
    for (int w = 0; w < planes.words(); ++w) count += std::popcount(plus[w] & ~used(grid, j, k, w));
  }
  return static_cast<std::uint64_t>(count);
}

std::uint64_t GradedCells::tets_left_out(int j, int k) const {
  int count = 0;
  for (int w = 0; w < even_.grid().words(); ++w)
    for (const std::uint64_t of_case : structured(j, k, w)) count += std::popcount(~of_case);
  return static_cast<std::uint64_t>(count);
}

std::int32_t GradedCells::layers_behind() const {
  // The farthest is the centre of the next cell of the top level.
  return (3 << octree_.top()) / 2;
}

}  // namespace certet::core
