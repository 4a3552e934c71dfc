#pragma once
/// \file
/// The vertices of several materials as runs along the rows of the lattice.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/context.hpp"
#include "material_links.hpp"
#include "sign_planes.hpp"

namespace certet::core {

/// Neighbouring plus vertices [begin, end) of a row, of one material.
struct RegionRun {
  std::int32_t begin, end;
  Material material;
};

/// Runs are numbered layer by layer, row by row, even ones of a row before odd ones.
class RegionRuns {
 public:
  /// Of planes with materials.  \throws Error `too_large` if 32 bits do not count them,
  /// `cancelled`.
  RegionRuns(const SignPlanes& planes, Context& context);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(runs_.size()); }
  [[nodiscard]] const RegionRun& operator[](std::uint32_t run) const { return runs_[run]; }
  /// The number of the first run of a row, and the row's runs.
  [[nodiscard]] std::uint32_t first(Grid grid, int j, int k) const { return first_[at(grid, j, k)]; }
  [[nodiscard]] std::span<const RegionRun> row(Grid grid, int j, int k) const {
    const std::size_t n = at(grid, j, k);
    return std::span(runs_).subspan(first_[n], first_[n + 1] - first_[n]);
  }
  /// The run of a plus vertex.
  [[nodiscard]] std::uint32_t run_of(const VertexIndex& v) const;

 private:
  [[nodiscard]] std::size_t at(Grid grid, int j, int k) const {
    return (static_cast<std::size_t>(k) * rows_ + static_cast<std::size_t>(j)) * grid_count + grid;
  }

  std::size_t rows_;  ///< of a layer and a grid
  std::vector<std::uint32_t> first_;  ///< of each row; one entry more at the end
  std::vector<RegionRun> runs_;
};

}  // namespace certet::core
