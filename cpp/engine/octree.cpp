#include "octree.hpp"

#include <array>

#include "asked_cells.hpp"
#include "layer_loop.hpp"

namespace certet::core {
namespace {

/// The cells of a word whose centre and its fourteen neighbours, the cell's corners and the
/// centres across its faces, are inside and of one material: the surface can do without them.
std::uint64_t interior_cells(const SignPlanes& planes, const SignRows& signs, int j, int k,
                             int w) {
  const Grid centres = grids.back();
  const VertexRef centre{centres, {}};
  std::uint64_t inside = signs.at(centre, w).plus;
  for (std::size_t d = 0; d < tiling.directions.size() && inside != 0; ++d)
    inside &= signs.at(neighbor(centres, d), w).plus;
  const MaterialPlanes* const materials = planes.materials();
  if (materials == nullptr) return inside;
  for (std::size_t d = 0; d < tiling.directions.size() && inside != 0; ++d)
    inside &= materials->alike(centre, neighbor(centres, d), j, k, w);
  return inside;
}

CellPlane cells_near_surface(const SignPlanes& planes, const Lattice& lattice,
                             Context& context) {
  CellPlane cells{LevelGrid(lattice)};
  for_each_layer(context, Stage::count, whole(lattice), [&](std::int32_t k) {
    for (int j = 0; j < lattice.cells[1]; ++j) {
      const SignRows signs(planes, j, k);
      std::uint64_t* const row = cells.words(j, k);
      for (int w = 0; w < planes.words(); ++w)
        row[w] = ~interior_cells(planes, signs, j, k, w);
    }
  });
  return cells;
}

/// Of the four cells along an axis that a parent may exist for: whether it is a child.
constexpr bool is_within(int step) { return step == 0 || step == 1; }

/// Whether parents of a word exist: with a child of theirs, or a neighbour of one across a
/// face or an edge.  Of four cells along each axis that is all but the eight outermost.
std::uint64_t parents(const CellPlane& children, int j, int k, int w) {
  const LevelGrid& grid = children.grid();
  const int x = -grid.is_upper(0);
  std::array<std::uint64_t, 2> found{};  ///< of two words of children
  for (int z = -1; z <= 2; ++z)
    for (int y = -1; y <= 2; ++y) {
      const BitRow row = children.row(2 * j - grid.is_upper(1) + y, 2 * k - grid.is_upper(2) + z);
      for (int half = 0; half < 2; ++half) {
        std::uint64_t& any = found[static_cast<std::size_t>(half)];
        const int at = 2 * w + half;
        any |= row.shifted(at, x) | row.shifted(at, x + 1);
        if (is_within(y) || is_within(z)) any |= row.shifted(at, x - 1) | row.shifted(at, x + 2);
      }
    }
  return every_second(found[0], found[1]);
}

template <class WordAt>
CellPlane made(const LevelGrid& grid, Context& context, const WordAt& word_at) {
  CellPlane plane(grid);
  for_each_layer(context, Stage::count, {0, grid.cells[2]}, [&](std::int32_t k) {
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int w = 0; w < grid.words(); ++w) plane.words(j, k)[w] = word_at(j, k, w);
  });
  return plane;
}

/// Points that are a corner of any of the eight cells around them.
std::uint64_t corners_of(const CellPlane& cells, int j, int k, int w) {
  std::uint64_t any = 0;
  for (const int z : {-1, 0})
    for (const int y : {-1, 0}) {
      const BitRow row = cells.row(j + y, k + z);
      any |= row[w] | row.shifted(w, -1);
    }
  return any;
}

void add_cells(const CellPlane& asked, CellPlane& cells, Context& context) {
  const LevelGrid& grid = cells.grid();
  for_each_layer(context, Stage::count, {0, grid.cells[2]}, [&](std::int32_t k) {
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int w = 0; w < grid.words(); ++w) cells.words(j, k)[w] |= asked.words(j, k)[w];
  });
}

}  // namespace

Octree::Octree(const SignPlanes& planes, const Lattice& lattice, const Grading& grading,
               Context& context) {
  grids_.emplace_back(lattice);
  std::vector<CellPlane> asked;
  for (int level = 0; level < grading.levels; ++level) {
    if (level == 0) {
      cells_.push_back(cells_near_surface(planes, lattice, context));
      asked = asked_cells(planes, lattice, cells_.front(), grading, context);
    } else {
      const CellPlane& children = cells_.back();
      cells_.push_back(made(grids_.back(), context, [&children](int j, int k, int w) {
        return parents(children, j, k, w);
      }));
    }
    if (!asked.empty()) add_cells(asked[static_cast<std::size_t>(level)], cells_.back(), context);
    grids_.push_back(grids_.back().coarser());
  }
  find_corners(context);
}

void Octree::find_corners(Context& context) {
  for (const CellPlane& cells : cells_)
    corners_.push_back(made(cells.grid(), context, [&cells](int j, int k, int w) {
      return corners_of(cells, j, k, w);
    }));
}

std::uint64_t Octree::bytes() const {
  std::uint64_t bytes = 0;
  for (const CellPlane& plane : cells_) bytes += plane.bytes();
  for (const CellPlane& plane : corners_) bytes += plane.bytes();
  return bytes;
}

}  // namespace certet::core
