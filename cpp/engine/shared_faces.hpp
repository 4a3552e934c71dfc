#pragma once
/// \file
/// Which tetrahedra of a mesh share a face, by where the stencils put them: no face is
/// compared with another.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/stuffing.hpp"
#include "lattice/cell_tables.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

class StencilChoice;

/// Where the tetrahedra of a layer are, in the order in which they are emitted.
class LayerTets {
 public:
  LayerTets(const WarpedLattice& warped, int k);

  /// Visits all pairs of the layer, batch by batch.
  void visit_within(const VisitTetPairs& visit) const;
  /// Visits all pairs of a tetrahedron of this layer and one of the next.
  void visit_between(const LayerTets& next, const VisitTetPairs& visit) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff, inside = 0xfffffffe;

  /// The tetrahedra of one index: none, twelve, or some, by the signs and cuts around.
  struct Cell {
    std::uint32_t begin = 0;
    std::uint32_t surface = none;  ///< which of `surface_`, or `inside`
  };
  /// Those of each case.
  struct SurfaceCell {
    std::array<std::uint8_t, cell_tet_count> stencil, begin;
  };
  struct CaseTets {
    std::uint32_t begin;
    std::uint8_t stencil;
  };

  void add_row(const SignPlanes& planes, const StencilChoice& stencil_of, int j, int k);
  SurfaceCell surface_cell(const std::array<Sign, cell_vertex_count>& sign,
                           const StencilChoice& stencil_of, int w, int b);
  [[nodiscard]] const Cell& cell_at(int i, int j) const {
    return cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(i)];
  }
  [[nodiscard]] CaseTets at(const Cell& cell, std::size_t c) const;
  void visit(const LayerTets& other, std::int8_t layers, const VisitTetPairs& visit) const;

  int columns_, rows_;
  std::uint32_t next_ = 0;  ///< the number of the next tetrahedron
  std::vector<Cell> cells_;
  std::vector<SurfaceCell> surface_;
};

}  // namespace certet::core
