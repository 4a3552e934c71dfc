#include "cell_planes.hpp"

namespace certet::core {
namespace {

/// Every second bit of a word, in its lower half.
constexpr std::uint64_t squeezed(std::uint64_t x) {
  x &= 0x5555555555555555;
  x = (x | x >> 1) & 0x3333333333333333;
  x = (x | x >> 2) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x >> 4) & 0x00ff00ff00ff00ff;
  x = (x | x >> 8) & 0x0000ffff0000ffff;
  return (x | x >> 16) & 0x00000000ffffffff;
}

}  // namespace

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

std::uint64_t every_second(std::uint64_t low, std::uint64_t high) {
  return squeezed(low) | squeezed(high) << 32;
}

CellPlane::CellPlane(const LevelGrid& grid)
    : grid_(grid), words_(static_cast<std::size_t>(grid.words()) *
                              static_cast<std::size_t>(grid.cells[1]) *
                              static_cast<std::size_t>(grid.cells[2]),
                          ~std::uint64_t{0}) {}

}  // namespace certet::core
