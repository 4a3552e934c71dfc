#include "warped_lattice.hpp"

#include <array>

#include "parallel.hpp"
#include "row_window.hpp"

namespace certet::core {
namespace {

/// The edges around the 64 vertices of a word: for each direction, which of the
/// vertices have a cut on that edge.
struct CutEdges {
  std::uint64_t plus;  ///< the vertices that are plus
  std::uint64_t any;   ///< those with a cut anywhere
  std::array<std::uint64_t, direction_count> towards;

  CutEdges(const SignPlanes& planes, Grid grid, int j, int k, int w) : any(0) {
    const SignWord own = signs_at(planes, {grid, {}}, j, k, w);
    plus = own.plus;
    for (std::size_t d = 0; d < direction_count; ++d) {
      const SignWord other = signs_at(planes, neighbor(grid, d), j, k, w);
      towards[d] = (own.plus & other.minus()) | (own.minus() & other.plus);
      any |= towards[d];
    }
  }

  /// The directions of the cuts around vertex b, as bits.
  [[nodiscard]] std::uint32_t around(int b) const {
    std::uint32_t directions = 0;
    for (std::size_t d = 0; d < direction_count; ++d)
      directions |= static_cast<std::uint32_t>(towards[d] >> b & 1) << d;
    return directions;
  }
};

/// Decides over the vertices of one layer.
class LayerWarper {
 public:
  LayerWarper(const SignPlanes& planes, const std::vector<CutLayer>& cuts,
              const Thresholds& thresholds, int k)
      : planes_(planes), cuts_(cuts), thresholds_(thresholds), k_(k),
        window_(planes, -1, k - 1) {}

  ZeroLayer warp_layer(SignPlanes& violated) {
    ZeroLayer moves;
    for (j_ = 0; j_ < planes_.cells()[1]; ++j_, window_.next()) {
      moves.row_begin.push_back(static_cast<std::uint32_t>(moves.displacements.size()));
      for (const Grid grid : {even, odd})
        for (int w = 0; w < planes_.words(); ++w)
          violated.plus(grid, j_, k_)[w] = warp_word(grid, w, moves);
    }
    return moves;
  }

 private:
  std::uint64_t warp_word(Grid grid, int w, ZeroLayer& moves) const {
    const CutEdges edges(planes_, grid, j_, k_, w);
    std::uint64_t violated = 0;
    for_each_bit(edges.any, [&](int b) {
      const Warping warping = warp_vertex(edges, grid, w, b);
      if (!warping.moves()) return;
      violated |= std::uint64_t{1} << b;
      moves.displacements.push_back({static_cast<std::uint16_t>(warping.distance),
                                     static_cast<std::uint8_t>(warping.direction)});
    });
    return violated;
  }

  Warping warp_vertex(const CutEdges& edges, Grid grid, int w, int b) const {
    const bool plus = (edges.plus >> b & 1) != 0;
    const std::uint32_t cut_edges = edges.around(b);
    std::array<std::int32_t, direction_count> cut;
    for (std::uint32_t left = cut_edges; left != 0; left &= left - 1) {
      const auto d = static_cast<std::size_t>(std::countr_zero(left));
      const std::int32_t from_plus = cut_on(edges_of[grid][d], w, b);
      cut[d] = plus ? from_plus : steps - from_plus;
    }
    return warp(thresholds_, cut_edges, cut);
  }

  std::int32_t cut_on(const EdgeRef& edge, int w, int b) const {
    const WordBit at = WordBit{w, b}.moved(edge.owner.x);
    const RowRanks& row = window_.row(static_cast<std::size_t>(1 + edge.owner.y),
                                      static_cast<std::size_t>(1 + edge.owner.z));
    const CutLayer& layer = cuts_[static_cast<std::size_t>(k_ + edge.owner.z)];
    return layer.at(j_ + edge.owner.y, row, row.rank(edge.kind, at.w, at.b));
  }

  const SignPlanes& planes_;
  const std::vector<CutLayer>& cuts_;
  const Thresholds& thresholds_;
  int k_;
  int j_ = 0;
  RowWindow window_;  ///< rows j-1..j of layers k-1..k
};

/// The cuts that are left in layer k, in the order of the new signs.
CutLayer remaining_cuts(const SignPlanes& before, const CutLayer& cuts, const SignPlanes& after,
                        int k) {
  CutLayer left;
  RowRanks old_row;
  RowRanks new_row;
  for (int j = 0; j < after.cells()[1]; ++j) {
    old_row.compute(before, j, k);
    new_row.compute(after, j, k);
    left.row_begin.push_back(static_cast<std::uint32_t>(left.steps.size()));
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
    for (const Grid grid : {even, odd})
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

Violations::Violations(const SignPlanes& planes, const std::vector<CutLayer>& cuts,
                       const Thresholds& thresholds, Context& context)
    : planes_(planes), cuts_(cuts), violated_(planes.cells()),
      moves_(static_cast<std::size_t>(planes.cells()[2])) {
  parallel_for(context, Stage::warp, planes.cells()[2], [&](std::int64_t k) {
    moves_[static_cast<std::size_t>(k)] =
        LayerWarper(planes, cuts, thresholds, static_cast<int>(k)).warp_layer(violated_);
  });
}

WarpedLattice Violations::apply(Context& context) const {
  const std::int32_t layers = planes_.cells()[2];
  WarpedLattice warped{planes_, std::vector<CutLayer>(static_cast<std::size_t>(layers)),
                       std::vector<ZeroLayer>(static_cast<std::size_t>(layers))};
  SignPlanes& after = warped.planes;
  const auto for_each_word = [&](const auto& visit) {
    for (int j = 0; j < after.cells()[1]; ++j)
      for (const Grid grid : {even, odd})
        for (int w = 0; w < after.words(); ++w) visit(grid, j, w);
  };
  parallel_for(context, Stage::warp, layers, [&](std::int64_t layer) {
    const int k = static_cast<int>(layer);
    for_each_word([&](Grid grid, int j, int w) {
      after.plus(grid, j, k)[w] &= ~violated_.plus(grid, j, k)[w];
    });
  });
  parallel_for(context, Stage::warp, layers, [&](std::int64_t layer) {
    const int k = static_cast<int>(layer);
    for_each_word([&](Grid grid, int j, int w) {
      std::uint64_t& zero = after.zero(grid, j, k)[w];
      zero |= violated_.plus(grid, j, k)[w];
      if (zero == 0) return;
      std::uint64_t any_plus = 0;
      for (std::size_t d = 0; d < direction_count; ++d) {
        const VertexRef ref = neighbor(grid, d);
        any_plus |= shifted(after.plus(ref.grid, j + ref.shift.y, k + ref.shift.z), w, ref.shift.x);
      }
      zero &= any_plus;
    });
  });
  parallel_for(context, Stage::warp, layers, [&](std::int64_t layer) {
    const int k = static_cast<int>(layer);
    const std::size_t at = static_cast<std::size_t>(layer);
    warped.cuts[at] = remaining_cuts(planes_, cuts_[at], after, k);
    warped.zeros[at] = remaining_zeros(violated_, moves_[at], after, k);
  });
  return warped;
}

}  // namespace certet::core
