#pragma once
/// \file
/// The structured tetrahedra all of whose corners are zero.
///
/// They are no part of a solid.  Where several materials meet, such a one is of the
/// material that is the lower one of each corner, if that is not the outside.

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "certet/context.hpp"
#include "lattice/cell_tables.hpp"
#include "link.hpp"
#include "row_ranks.hpp"
#include "vertex_index.hpp"

namespace certet::core {

/// A structured tetrahedron: a case of a cell.
struct CaseIndex {
  std::int32_t k, j, i;
  std::uint8_t number;
  friend auto operator<=>(const CaseIndex&, const CaseIndex&) = default;

  [[nodiscard]] VertexIndex corner(std::size_t n) const {
    return VertexIndex{even, i, j, k}.at(cell.vertices[cell.corner[number][n]]);
  }
};

/// Calls visit(tet) for those of the cells of row (j,k).
template <class Visit>
void for_each_zero_tet(const SignPlanes& planes, int j, int k, const Visit& visit) {
  for (int w = 0; w < planes.words(); ++w) {
    std::array<std::uint64_t, cell_vertex_count> zero;
    std::uint64_t any = 0;
    for (std::size_t v = 0; v < cell_vertex_count; ++v) {
      const auto& [grid, shift] = cell.vertices[v];
      any |= zero[v] = shifted(planes.zero(grid, j + shift.y, k + shift.z), w, shift.x);
    }
    if (any == 0) continue;
    for (std::uint8_t c = 0; c < cell_tet_count; ++c) {
      const auto& corner = cell.corner[c];
      for_each_bit(zero[corner[0]] & zero[corner[1]] & zero[corner[2]] & zero[corner[3]],
                   [&](int b) { visit(CaseIndex{k, j, 64 * w + b, c}); });
    }
  }
}

/// Its material, or 0 if it is no part of the mesh.
Material material_of_zero_tet(const SignPlanes& planes, const CaseIndex& tet);

/// Those of a whole lattice that are part of the mesh, in their order.
class ZeroTets {
 public:
  ZeroTets(const SignPlanes& planes, Context& context);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(tets_.size()); }
  [[nodiscard]] const CaseIndex& operator[](std::size_t n) const { return tets_[n]; }
  /// Of any, the number of one of these.
  [[nodiscard]] std::optional<std::uint32_t> find(const CaseIndex& tet) const;

 private:
  [[nodiscard]] std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(k) * rows_ + static_cast<std::size_t>(j);
  }

  std::size_t rows_;  ///< of a layer
  std::vector<CaseIndex> tets_;
  std::vector<std::uint32_t> first_;  ///< of each row of cells; one entry more at the end
};

/// The structured tetrahedron of a vertex and a triangle of its link.
CaseIndex case_at(const VertexIndex& v, std::size_t triangle);

}  // namespace certet::core
