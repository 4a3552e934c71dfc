#pragma once
/// \file
/// The octree of a mesh whose interior is graded: `Octree.v` and `Surface.v` of the
/// certificate.

#include <cstdint>
#include <span>
#include <vector>

#include "cell_planes.hpp"
#include "certet/context.hpp"
#include "certet/grading.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// Which cells exist.  A cell of level 0 is the cube between eight even vertices, those of a
/// level are twice as large as those a level below.  A cell may have any of its eight
/// children; where it has none it fills the place itself.  Of the top level all exist.
class Octree {
 public:
  /// The least octree of so many levels above level 0 that keeps every cell with a vertex
  /// near it that is not inside, by the signs after warping, or is of another material:
  /// `GradedOctree`; and the cells that sizes ask for: `OctreeAround`.
  Octree(const SignPlanes& planes, const Lattice& lattice, const Grading& grading,
         Context& context);

  /// The level of which all cells exist.
  [[nodiscard]] int top() const { return static_cast<int>(cells_.size()); }
  [[nodiscard]] const LevelGrid& grid(int level) const {
    return grids_[static_cast<std::size_t>(level)];
  }
  /// Which cells of a row exist; of a row beside those that touch the lattice all do.
  [[nodiscard]] BitRow cells(int level, int j, int k) const {
    return level < top() ? cells_[static_cast<std::size_t>(level)].row(j, k) : BitRow(nullptr, 0);
  }
  /// Which points of a row are corners of cells that exist: `IsUsed` a level above.
  [[nodiscard]] BitRow corners(int level, int j, int k) const {
    return corners_[static_cast<std::size_t>(level)].row(j, k);
  }
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  void find_corners(Context& context);

  std::vector<LevelGrid> grids_;    ///< by level, the top with them
  std::vector<CellPlane> cells_;    ///< by level, below the top
  std::vector<CellPlane> corners_;  ///< of these
};

}  // namespace certet::core
