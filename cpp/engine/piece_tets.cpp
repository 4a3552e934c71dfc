#include "piece_tets.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

#include "cell_word.hpp"
#include "layer_loop.hpp"
#include "material_cells.hpp"

namespace certet::core {
namespace {

/// Counts the tetrahedra of one row of cells after the other.
class PieceTets {
 public:
  PieceTets(const MeshParts& parts, const NumberedSets& pieces, std::vector<std::uint64_t>& tets)
      : parts_(parts), planes_(parts.runs.planes()), pieces_(pieces), tets_(tets) {}

  void add_row(int j, int k) {
    std::vector<RunCursor> cursors;
    cursors.reserve(cell_vertex_count);
    for (VertexRef v : cell.vertices) {
      // Behind the last row no vertex is plus, and none is asked for its run.
      if (j + v.shift.y == planes_.cells()[1]) v.shift.y = 0;
      if (k + v.shift.z == planes_.cells()[2]) v.shift.z = 0;
      cursors.push_back(parts_.runs.cursor(v, j, k));
    }
    const auto for_each_word = [&](const auto& visit) {
      for (int w = 0; w < planes_.words(); ++w) {
        for (RunCursor& cursor : cursors) cursor.next(w);
        visit(w);
      }
    };
    if (parts_.runs.have_materials()) {
      const MaterialCells cells(planes_, j, k);
      for_each_word([&](int w) { add_material_word(cells, cursors, j, k, w); });
    } else {
      const SignRows signs(planes_, j, k);
      for_each_word([&](int w) { add_word(signs, cursors, w); });
    }
  }

  void finish() {
    if (pending_ != 0)
      std::atomic_ref(tets_[piece_]).fetch_add(pending_, std::memory_order_relaxed);
    pending_ = 0;
  }

 private:
  void add_word(const SignRows& signs, const std::vector<RunCursor>& cursors, int w) {
    const CellWord word(signs, w);
    if (word.any_plus == 0) return;
    for (const auto& corner : cell.corner) {
      const StencilCounts counts = word.counts(corner);
      std::uint64_t left = counts.one;
      for (const std::size_t v : corner) {
        add_runs(left & word.vertex[v].plus, counts, cursors[v]);
        left &= ~word.vertex[v].plus;
      }
    }
  }

  /// The tetrahedra at some plus vertices of a word, run by run.
  void add_runs(std::uint64_t at, const StencilCounts& counts, const RunCursor& cursor) {
    while (at != 0) {
      const int b = std::countr_zero(at);
      const std::uint64_t run = at & cursor.rest_of_run(b);
      const auto count = [run](std::uint64_t bits) {
        return static_cast<std::uint64_t>(std::popcount(bits & run));
      };
      add(cursor.run(b), count(counts.one) + count(counts.two) + count(counts.three));
      at &= ~run;
    }
  }

  /// The same where several materials meet.
  void add_material_word(const MaterialCells& cells, const std::vector<RunCursor>& cursors, int j,
                         int k, int w) {
    const auto [any, whole] = cells.kinds(w);
    for_each_bit(whole, [&](int b) { add(cursors[0].run(b), cell_tet_count); });
    for_each_bit(any & ~whole, [&](int b) {
      cells.for_each_owned_tet(64 * w + b, [&](std::size_t c, const MaterialTet& tet, Material) {
        const CaseIndex at{k, j, 64 * w + b, static_cast<std::uint8_t>(c)};
        add(tet.owner == shared_owner ? parts_.runs.size() + *parts_.zero_tets.find(at)
                                      : cursors[cell.corner[c][tet.owner]].run(b),
            1);
      });
    });
  }

  void add(std::uint32_t part, std::uint64_t tets) {
    const std::uint32_t piece = pieces_.of[part];
    if (piece != piece_) finish();
    piece_ = piece;
    pending_ += tets;
  }

  const MeshParts& parts_;
  const SignPlanes& planes_;
  const NumberedSets& pieces_;
  std::vector<std::uint64_t>& tets_;
  std::uint32_t piece_ = 0;
  std::uint64_t pending_ = 0;
};

}  // namespace

NumberedSets number_sets(DisjointSets& sets) {
  NumberedSets numbered;
  numbered.of.resize(sets.size());
  for (std::uint32_t n = 0; n < sets.size(); ++n) {
    const std::uint32_t least = sets.find(n);
    numbered.of[n] = least == n ? numbered.count++ : numbered.of[least];
  }
  return numbered;
}

std::vector<std::uint64_t> count_tets_of_pieces(const MeshParts& parts,
                                                const NumberedSets& pieces, Context& context) {
  const SignPlanes& planes = parts.runs.planes();
  std::vector<std::uint64_t> tets(pieces.count, 0);
  for_each_layer(context, Stage::count, planes.window(), [&](std::int32_t k) {
    PieceTets layer(parts, pieces, tets);
    for (int j = 0; j < planes.cells()[1]; ++j) layer.add_row(j, k);
    layer.finish();
  });
  return tets;
}

}  // namespace certet::core
