#include <limits>

#include "cell_word.hpp"
#include "emit.hpp"
#include "emit_loop.hpp"
#include "graded_vertices.hpp"
#include "material_cells.hpp"
#include "row_window.hpp"
#include "stencil_choice.hpp"

namespace certet::core {
namespace {

/// The numbers of the even points around a row of cells above level 0.
template <class Index>
class CoarsePoints {
 public:
  CoarsePoints(const GradedCells& graded, const RowNumbers& numbers, const GradedVertices& vertices)
      : vertices_(vertices) {
    const auto& cells = graded.octree().grid(0).cells;
    for (std::size_t n = 0; n < coarse_row_count; ++n) {
      const auto [j, k] = vertices.row(n);
      if (j < 0 || j >= cells[1] || k < 0 || k >= cells[2]) continue;
      rows_[n] = {static_cast<Index>(numbers.first_point(j, k)), graded.ranks(j, k)};
    }
  }

  [[nodiscard]] Index number(CoarseVertex vertex, int cell) const {
    const Row& row = rows_[vertex.row];
    return static_cast<Index>(row.first + row.ranks[vertices_.index(vertex, cell)]);
  }

 private:
  struct Row {
    Index first = 0;
    GradedCells::EvenRanks ranks{nullptr, nullptr};
  };

  GradedVertices vertices_;
  std::array<Row, coarse_row_count> rows_{};
};

/// Emits row after row of one layer.
template <class Index>
class TetEmitter {
 public:
  TetEmitter(const WarpedLattice& warped, const RowNumbers& numbers, int j, int k,
             Tet<Index>* out)
      : planes_(warped.planes), numbers_(numbers), graded_(numbers.graded()), j_(j), k_(k),
        window_(planes_, j, k, graded_), stencil_of_(warped, window_), out_(out) {
    structured_.fill(~std::uint64_t{0});
  }

  void emit_row() {
    first_point_ = {{{row_number(j_, k_), row_number(j_, k_ + 1)},
                     {row_number(j_ + 1, k_), row_number(j_ + 1, k_ + 1)}}};
    if (planes_.materials() == nullptr) {
      const SignRows signs(planes_, j_, k_);
      for (int w = 0; w < planes_.words(); ++w) emit_word(signs, w);
    } else {
      const MaterialCells cells(planes_, j_, k_);
      for (int w = 0; w < planes_.words(); ++w) emit_material_word(cells, w);
    }
    if (graded_ != nullptr) emit_graded();
    ++j_;
    window_.next();
  }

 private:
  [[nodiscard]] Index row_number(int j, int k) const {
    const auto& cells = planes_.cells();
    if (j >= cells[1] || k >= cells[2]) return 0;
    return static_cast<Index>(numbers_.first_point(j, k));
  }

  void emit_word(const SignRows& signs, int w) {
    const CellWord word(signs, w);
    emit_cells(word.any_plus, word.all_plus, w, [&](int b) { emit_cell(word, w, b); });
  }

  /// The same where several materials meet.
  void emit_material_word(const MaterialCells& cells, int w) {
    const auto [any, whole] = cells.kinds(w);
    emit_cells(any, whole, w, [&](int b) {
      const std::array<Index, cell_vertex_count> number = corner_numbers(w, b);
      cells.for_each_tet(64 * w + b, [&](std::size_t c, const UnstructuredTet& tet, Material) {
        if (is_structured(c, b)) emit_tet(c, tet, number, w, b);
      });
    });
  }

  /// 64 cells: most have nothing inside, or all.  The former are passed over by the
  /// bits of `any`, runs of the latter need neither signs nor stencils; what is left
  /// are the cells around the surface.
  template <class EmitOne>
  void emit_cells(std::uint64_t any, std::uint64_t inside, int w, const EmitOne& emit_one) {
    std::uint64_t whole = inside;
    if (graded_ != nullptr && any != 0) keep_structured(w, any, whole);
    while (any != 0) {
      const int b = std::countr_zero(any);
      if ((whole >> b & 1) != 0) {
        const int length = std::countr_one(whole >> b);
        emit_interior(w, b, length);
        any = b + length == 64 ? 0 : any & ~below(b + length);
        continue;
      }
      if ((inside >> b & 1) != 0) emit_some(w, b);
      else emit_one(b);
      any &= any - 1;
    }
  }

  /// Finds which tetrahedra of word w a graded mesh has from the lattice; `any` loses the cells
  /// that have none left, `whole` those that have not all.
  void keep_structured(int w, std::uint64_t& any, std::uint64_t& whole) {
    structured_ = graded_->structured(j_, k_, w);
    std::uint64_t some = 0;
    for (const std::uint64_t of_case : structured_) {
      some |= of_case;
      whole &= of_case;
    }
    any &= some;
  }

  [[nodiscard]] bool is_structured(std::size_t c, int b) const {
    return (structured_[c] >> b & 1) != 0;
  }

  /// The tetrahedra of a graded mesh that the lattice has not, level by level.
  void emit_graded() {
    const Octree& octree = graded_->octree();
    for_each_graded_row(octree, j_, k_, [&](const GradedRow& row, int level, const RowOfCells& at) {
      if (level == 0) {
        row.for_each_in_row([&](int w, GradedKind, std::size_t flag, std::uint64_t cells) {
          emit_pyramids(pyramids_at_cells[flag], w, cells);
        });
        return;
      }
      const CoarsePoints<Index> points(*graded_, numbers_, GradedVertices(octree, level, at));
      row.for_each_in_row([&](int w, GradedKind kind, std::size_t flag, std::uint64_t cells) {
        emit_coarse(points, coarse_tets[static_cast<std::size_t>(kind)][flag], w, cells);
      });
    });
  }

  /// At cells of level 0, whose vertices are those of the row.
  void emit_pyramids(const std::array<VertexRef, 4>& vertices, int w, std::uint64_t cells) {
    for_each_bit(cells, [&](int b) {
      for (std::size_t v = 0; v < 4; ++v)
        (*out_)[v] = point(vertices[v].grid, vertices[v].shift, w, b);
      ++out_;
    });
  }

  void emit_coarse(const CoarsePoints<Index>& points, const std::array<CoarseVertex, 4>& vertices,
                   int w, std::uint64_t cells) {
    for_each_bit(cells, [&](int b) {
      for (std::size_t v = 0; v < 4; ++v) (*out_)[v] = points.number(vertices[v], 64 * w + b);
      ++out_;
    });
  }

  /// The number of a point `kind` whose owner is `owner` away from bit b, by its rank
  /// in the owner's row: cpp/docs/pictures/ranks.svg.
  [[nodiscard]] Index point(std::size_t kind, Shift owner, int w, int b) const {
    const auto y = static_cast<std::size_t>(int{owner.y});
    const auto z = static_cast<std::size_t>(int{owner.z});
    const WordBit at = WordBit{w, b}.moved(owner.x);
    return static_cast<Index>(first_point_[y][z] +
                              window_.row(y, z).rank(kind, at.w, at.b));
  }

  /// The numbers of a cell's vertices; of those that are no points they mean nothing.
  [[nodiscard]] std::array<Index, cell_vertex_count> corner_numbers(int w, int b) const {
    std::array<Index, cell_vertex_count> number;
    for (std::size_t v = 0; v < cell_vertex_count; ++v)
      number[v] = point(cell.vertices[v].grid, cell.vertices[v].shift, w, b);
    return number;
  }

  /// Cells whose vertices are all inside: along the row every number grows by one.
  void emit_interior(int w, int b, int length) {
    const std::array<Index, cell_vertex_count> number = corner_numbers(w, b);
    std::array<Index, interior_size> current;
    for (std::size_t n = 0; n < interior_size; ++n) current[n] = number[interior_vertices[n]];
    Index* to = out_->data();
    for (int i = 0; i < length; ++i, to += interior_size)
      for (std::size_t n = 0; n < interior_size; ++n) to[n] = current[n]++;
    out_ += length * int{cell_tet_count};
  }

  /// A cell whose vertices are all inside, and which has lost some of its tetrahedra.
  void emit_some(int w, int b) {
    const std::array<Index, cell_vertex_count> number = corner_numbers(w, b);
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      if (!is_structured(c, b)) continue;
      for (std::size_t n = 0; n < 4; ++n) (*out_)[n] = number[interior_vertices[4 * c + n]];
      ++out_;
    }
  }

  /// A cell with the surface in or near it: case by case, by the stencils
  /// (cpp/docs/pictures/stencils.svg).
  void emit_cell(const CellWord& word, int w, int b) {
    const std::array<Sign, cell_vertex_count> sign = word.signs(b);
    const std::array<Index, cell_vertex_count> number = corner_numbers(w, b);
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      if (!is_structured(c, b)) continue;
      const auto& corner = cell.corner[c];
      const auto pattern = static_cast<std::size_t>(pattern_index(
          sign[corner[0]], sign[corner[1]], sign[corner[2]], sign[corner[3]]));
      for (const UnstructuredTet& tet : stencils[stencil_of_(pattern, c, w, b)])
        emit_tet(c, tet, number, w, b);
    }
  }

  void emit_tet(std::size_t c, const UnstructuredTet& tet,
                const std::array<Index, cell_vertex_count>& number, int w, int b) {
    for (std::size_t n = 0; n < 4; ++n) {
      const StencilVertex v = tet[output_orders[c][n]];
      (*out_)[n] = v.is_cut() ? cut_number(c, v, w, b) : number[cell.corner[c][v.a]];
    }
    ++out_;
  }

  [[nodiscard]] Index cut_number(std::size_t c, StencilVertex v, int w, int b) const {
    const EdgeRef& edge = cell.edge[c][v.a][v.b];
    return point(edge.kind, edge.owner, w, b);
  }

  const SignPlanes& planes_;
  const RowNumbers& numbers_;
  const GradedCells* graded_;  ///< or none: every tetrahedron of the lattice is there
  OfCases structured_;  ///< of the word that is emitted
  int j_, k_;
  RowWindow window_;  ///< rows j..j+1 of layers k..k+1
  StencilChoice stencil_of_;
  std::array<std::array<Index, 2>, 2> first_point_{};
  Tet<Index>* out_;
};

}  // namespace

template <class Index>
void emit_tets(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
               Window window, std::span<Tet<Index>> out, Context& context) {
  const std::uint64_t start = numbers.first_tet(0, window.begin);
  check_room(out.size(), numbers.first_tet(0, window.end) - start);
  if (numbers.last_point() > std::numeric_limits<Index>::max())
    throw Error(ErrorCode::too_large, "the numbers of the points do not fit in " +
                                          std::to_string(8 * sizeof(Index)) + " bits");
  for_each_piece(lattice, window, context, [&](int j_begin, int j_end, int k) {
    TetEmitter<Index> emitter(warped, numbers, j_begin, k,
                              out.data() + (numbers.first_tet(j_begin, k) - start));
    for (int j = j_begin; j < j_end; ++j) emitter.emit_row();
  });
}

template void emit_tets(const WarpedLattice&, const RowNumbers&, const Lattice&, Window,
                        std::span<Tet<std::uint32_t>>, Context&);
template void emit_tets(const WarpedLattice&, const RowNumbers&, const Lattice&, Window,
                        std::span<Tet<std::uint64_t>>, Context&);

}  // namespace certet::core
