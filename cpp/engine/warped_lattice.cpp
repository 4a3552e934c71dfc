#include "warped_lattice.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "layer_loop.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

/// The cuts that violate the vertices of one row, collected from the edges.
class ViolatedRow {
 public:
  explicit ViolatedRow(int words)
      : words_(words), violated_(static_cast<std::size_t>(grid_count * words)),
        vertices_(static_cast<std::size_t>(grid_count * words) * 64) {}

  void add(Grid grid, int i, int direction, std::int32_t cut) {
    const std::size_t word = word_of(grid, i >> 6);
    violated_[word] |= std::uint64_t{1} << (i & 63);
    Vertex& vertex = vertices_[64 * word + static_cast<std::size_t>(i & 63)];
    vertex.edges |= std::uint32_t{1} << direction;
    vertex.cut[static_cast<std::size_t>(direction)] = cut;
  }

  /// Where the vertices of a word go, in the order of the index; they are
  /// forgotten then.  \returns which ones move.
  std::uint64_t take(Grid grid, int w, const Thresholds& thresholds,
                     std::vector<Displacement>& moves) {
    const std::size_t word = word_of(grid, w);
    for_each_bit(violated_[word], [&](int b) {
      Vertex& vertex = vertices_[64 * word + static_cast<std::size_t>(b)];
      const Warping warping = warp(thresholds, std::exchange(vertex.edges, 0), vertex.cut);
      moves.push_back({static_cast<std::uint16_t>(warping.distance),
                       static_cast<std::uint8_t>(warping.direction)});
    });
    return std::exchange(violated_[word], 0);
  }

 private:
  struct Vertex {
    std::uint32_t edges = 0;  ///< a bit for each direction
    std::array<std::int32_t, direction_count> cut;
  };
  [[nodiscard]] std::size_t word_of(Grid grid, int w) const {
    const int word = grid * words_ + w;
    return static_cast<std::size_t>(word);
  }

  int words_;
  std::vector<std::uint64_t> violated_;
  std::vector<Vertex> vertices_;
};

/// Decides over the vertices of one layer.  Goes through the cuts once, in
/// their order, and leaves each with the end that it violates, if any: memory is
/// read as it lies, where to ask each vertex for its 14 edges would look every cut
/// up twice by its rank.  The ends of a row's cuts are in two rows, so that two rows
/// of vertices, taken in turns, are in hand.  Picture: cpp/docs/pictures/warping.svg.
class LayerWarper {
 public:
  LayerWarper(const SignPlanes& planes, const Layers<CutLayer>& cuts,
              const Thresholds& thresholds, int k)
      : planes_(planes), cuts_(cuts), thresholds_(thresholds), k_(k),
        rows_{ViolatedRow(planes.words()), ViolatedRow(planes.words())} {}

  ZeroLayer warp_layer(SignPlanes& violated) {
    ZeroLayer moves;
    for (int j = 0; j < planes_.cells()[1]; ++j) {
      if (cuts_.window().contains(k_ - 1)) collect(j, k_ - 1);
      collect(j, k_);
      moves.row_begin.push_back(static_cast<std::uint32_t>(moves.displacements.size()));
      for (const Grid grid : grids)
        for (int w = 0; w < planes_.words(); ++w)
          violated.plus(grid, j, k_)[w] =
              rows_[j & 1].take(grid, w, thresholds_, moves.displacements);
    }
    return moves;
  }

 private:
  /// The cuts that row (j,k) owns.  Their ends are in rows j and j + 1, and in
  /// layers k and k + 1.
  void collect(int j, int k) {
    row_.compute(planes_, j, k);
    const CutLayer& layer = cuts_[k];
    const std::uint16_t* cut = layer.steps.data() + layer.row_begin[static_cast<std::size_t>(j)];
    for (std::size_t f = 0; f < family_count; ++f) {
      const bool first_counts = k == k_;
      const bool second_counts = k + families[f].second.shift.z == k_;
      for (int w = 0; w < row_.words(); ++w) {
        const std::uint64_t mask = row_.mask(corner_kinds + f, w);
        const std::uint64_t first_plus =
            planes_.plus(families[f].first.grid, j, k)[static_cast<std::size_t>(w)];
        if (first_counts || second_counts)
          collect_word(f, j, w, mask, first_plus, cut, {first_counts, second_counts});
        cut += std::popcount(mask);
      }
    }
  }

  void collect_word(std::size_t f, int j, int w, std::uint64_t mask, std::uint64_t first_plus,
                    const std::uint16_t* cut, std::array<bool, 2> counts) {
    const std::int32_t threshold = thresholds_.in_steps(family_directions[f][0]);
    for_each_bit(mask, [&](int b) {
      const std::int32_t from_plus = *cut++;
      const std::int32_t from_minus = steps - from_plus;
      const bool plus = from_plus < threshold;
      if (!plus && from_minus >= threshold) return;
      const bool second = plus != ((first_plus >> b & 1) != 0);
      if (!counts[second]) return;
      const VertexRef& end = second ? families[f].second : families[f].first;
      ViolatedRow& row = rows_[static_cast<std::size_t>((j + end.shift.y) & 1)];
      row.add(end.grid, 64 * w + b + end.shift.x, family_directions[f][second],
              plus ? from_plus : from_minus);
    });
  }

  const SignPlanes& planes_;
  const Layers<CutLayer>& cuts_;
  const Thresholds& thresholds_;
  int k_;
  RowRanks row_;
  std::array<ViolatedRow, 2> rows_;  ///< of the even and the odd row in hand
};

/// A cut is nearer to one end than the thresholds of both, so that it cannot
/// violate both.
static_assert(2 * std::max({angle_thresholds.long_edge, angle_thresholds.short_edge,
                            embedding_thresholds.long_edge, embedding_thresholds.short_edge}) <=
              threshold_denominator);

/// The cuts that are left in layer k, in the order of the new signs.
CutLayer remaining_cuts(const SignPlanes& before, const CutLayer& cuts, const SignPlanes& after,
                        int k) {
  CutLayer left;
  RowRanks old_row;
  RowRanks new_row;
  for (int j = 0; j < after.cells()[1]; ++j) {
    old_row.compute(before, j, k);
    new_row.compute(after, j, k);
    left.row_begin.push_back(left.steps.size());
    for (std::size_t kind = corner_kinds; kind < kind_count; ++kind)
      for (int w = 0; w < new_row.words(); ++w)
        for_each_bit(new_row.mask(kind, w), [&](int b) {
          left.steps.push_back(
              static_cast<std::uint16_t>(cuts.at(j, old_row, old_row.rank(kind, w, b))));
        });
  }
  return left;
}

/// The displacements of the zero vertices of layer k that are left.
ZeroLayer remaining_zeros(const SignPlanes& violated, const ZeroLayer& moves,
                          const SignPlanes& after, int k) {
  ZeroLayer left;
  std::size_t next_move = 0;
  for (int j = 0; j < after.cells()[1]; ++j) {
    left.row_begin.push_back(static_cast<std::uint32_t>(left.displacements.size()));
    for (const Grid grid : grids)
      for (int w = 0; w < after.words(); ++w) {
        const std::uint64_t moved = violated.plus(grid, j, k)[w];
        const std::uint64_t zero = after.zero(grid, j, k)[w];
        for_each_bit(moved | zero, [&](int b) {
          Displacement displacement;
          if (moved >> b & 1) displacement = moves.displacements[next_move++];
          if (zero >> b & 1) left.displacements.push_back(displacement);
        });
      }
  }
  return left;
}

}  // namespace

Violations::Violations(const SignPlanes& planes, const Layers<CutLayer>& cuts,
                       const Lattice& lattice, Window window, const Thresholds& thresholds,
                       Context& context)
    : planes_(planes), cuts_(cuts), lattice_(lattice), window_(window),
      violated_(lattice.cells, violation_window(window, lattice)), moves_(violated_.window()) {
  for_each_layer(context, Stage::warp, violated_.window(), [&](std::int32_t k) {
    moves_[k] = LayerWarper(planes, cuts, thresholds, k).warp_layer(violated_);
  });
}

WarpedLattice Violations::apply(Context& context) const {
  WarpedLattice warped{SignPlanes(planes_, violated_.window()), Layers<CutLayer>(window_),
                       Layers<ZeroLayer>(window_)};
  SignPlanes& after = warped.planes;
  const auto for_each_word = [&](const auto& visit) {
    for (int j = 0; j < after.cells()[1]; ++j)
      for (const Grid grid : grids)
        for (int w = 0; w < after.words(); ++w) visit(grid, j, w);
  };
  for_each_layer(context, Stage::warp, violated_.window(), [&](std::int32_t k) {
    for_each_word([&](Grid grid, int j, int w) {
      const std::uint64_t violated = violated_.plus(grid, j, k)[w];
      if (violated == 0) return;
      after.plus(grid, j, k)[w] &= ~violated;
      after.zero(grid, j, k)[w] |= violated;
    });
  });
  for_each_layer(context, Stage::warp, warped_window(window_, lattice_), [&](std::int32_t k) {
    for_each_word([&](Grid grid, int j, int w) {
      // Pruning, 64 vertices at once: cpp/docs/pictures/pruning.svg.
      std::uint64_t& zero = after.zero(grid, j, k)[w];
      if (zero == 0) return;
      std::uint64_t any_plus = 0;
      for (std::size_t d = 0; d < tiling.directions.size(); ++d) {
        const VertexRef ref = neighbor(grid, d);
        any_plus |= shifted(after.plus(ref.grid, j + ref.shift.y, k + ref.shift.z), w, ref.shift.x);
      }
      zero &= any_plus;
    });
  });
  for_each_layer(context, Stage::warp, window_, [&](std::int32_t k) {
    warped.cuts[k] = remaining_cuts(planes_, cuts_[k], after, k);
    warped.zeros[k] = remaining_zeros(violated_, moves_[k], after, k);
  });
  return warped;
}

WarpedLattice unwarped(SignPlanes planes, Layers<CutLayer> cuts, Window window) {
  Layers<ZeroLayer> zeros(window);
  for (std::int32_t k = window.begin; k < window.end; ++k)
    zeros[k].row_begin.assign(static_cast<std::size_t>(planes.cells()[1]), 0);
  return {std::move(planes), std::move(cuts), std::move(zeros)};
}

}  // namespace certet::core
