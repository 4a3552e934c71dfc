#include "cell_planes.hpp"

namespace certet::core {
LevelGrid::LevelGrid(const Lattice& lattice)
    : cells(lattice.cells),
      first{lattice.origin.x / 2, lattice.origin.y / 2, lattice.origin.z / 2} {}

LevelGrid LevelGrid::coarser() const {
  LevelGrid above = *this;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    above.first[axis] = first[axis] >> 1;
    above.cells[axis] = ((first[axis] + cells[axis] - 1) >> 1) - above.first[axis] + 1;
  }
  return above;
}

CellPlane::CellPlane(const LevelGrid& grid)
    : grid_(grid), words_(static_cast<std::size_t>(grid.words()) *
                              static_cast<std::size_t>(grid.cells[1]) *
                              static_cast<std::size_t>(grid.cells[2]),
                          ~std::uint64_t{0}) {}

}  // namespace certet::core
