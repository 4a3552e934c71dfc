#include "violations.hpp"

#include <algorithm>
#include <array>
#include <bit>
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

  /// The targets of the vertices of a word, in the order of the index; they are
  /// forgotten then.  \returns which ones are violated.
  std::uint64_t take(Grid grid, int w, const Thresholds& thresholds,
                     std::vector<Displacement>& targets) {
    const std::size_t word = word_of(grid, w);
    for_each_bit(violated_[word], [&](int b) {
      Vertex& vertex = vertices_[64 * word + static_cast<std::size_t>(b)];
      const std::uint32_t edges = std::exchange(vertex.edges, 0);
      const Warping warping = warp(thresholds, edges, vertex.cut);
      targets.push_back({static_cast<std::uint16_t>(warping.distance),
                         static_cast<std::uint8_t>(warping.direction),
                         std::has_single_bit(edges)});
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

/// Finds the violated vertices of one layer.  Goes through the cuts once, in
/// their order, and leaves each with the end that it violates, if any: memory is
/// read as it lies, where to ask each vertex for its 14 edges would look every cut
/// up twice by its rank.  The ends of a row's cuts are in two rows, so that two rows
/// of vertices, taken in turns, are in hand.  Picture: cpp/docs/pictures/warping.svg.
class LayerViolations {
 public:
  LayerViolations(const SignPlanes& planes, const Layers<CutLayer>& cuts,
                  const Thresholds& thresholds, int k)
      : planes_(planes), cuts_(cuts), thresholds_(thresholds), k_(k),
        rows_{ViolatedRow(planes.words()), ViolatedRow(planes.words())} {}

  DisplacedLayer find(SignPlanes& violated) {
    DisplacedLayer targets;
    for (int j = 0; j < planes_.cells()[1]; ++j) {
      if (cuts_.window().contains(k_ - 1)) collect(j, k_ - 1);
      collect(j, k_);
      targets.row_begin.push_back(static_cast<std::uint32_t>(targets.displacements.size()));
      for (const Grid grid : grids)
        for (int w = 0; w < planes_.words(); ++w) {
          collect_zeros(grid, j, w);
          violated.plus(grid, j, k_)[w] =
              rows_[j & 1].take(grid, w, thresholds_, targets.displacements);
        }
    }
    return targets;
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
        if (mask != 0 && (first_counts || second_counts))
          collect_word(f, j, w, mask, planes_.measured_from_first(f, j, k, w), cut,
                       {first_counts, second_counts});
        cut += std::popcount(mask);
      }
    }
  }

  void collect_word(std::size_t f, int j, int w, std::uint64_t mask, std::uint64_t from_first,
                    const std::uint16_t* cut, std::array<bool, 2> counts) {
    const std::int32_t threshold = thresholds_.in_steps(family_directions[f][0]);
    for_each_bit(mask, [&](int b) {
      const std::int32_t from_greater = *cut++;
      const std::int32_t from_lesser = steps - from_greater;
      const bool greater = from_greater < threshold;
      if (!greater && from_lesser >= threshold) return;
      const bool second = greater != ((from_first >> b & 1) != 0);
      if (!counts[second]) return;
      const VertexRef& end = second ? families[f].second : families[f].first;
      ViolatedRow& row = rows_[static_cast<std::size_t>((j + end.shift.y) & 1)];
      row.add(end.grid, 64 * w + b + end.shift.x, family_directions[f][second],
              greater ? from_greater : from_lesser);
    });
  }

  /// Samples that lie on the surface: the cut towards a plus neighbour is at the sample.
  void collect_zeros(Grid grid, int j, int w) {
    std::uint64_t rest = planes_.zero(grid, j, k_)[w];
    for (std::size_t d = 0; d < tiling.directions.size() && rest != 0; ++d) {
      const VertexRef to = neighbor(grid, d);
      const std::uint64_t cut =
          rest & shifted(planes_.plus(to.grid, j + to.shift.y, k_ + to.shift.z), w, to.shift.x);
      for_each_bit(cut, [&](int b) {
        rows_[j & 1].add(grid, 64 * w + b, static_cast<int>(d), 0);
      });
      rest &= ~cut;
    }
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
                            embedding_thresholds.long_edge, embedding_thresholds.short_edge,
                            key_thresholds.long_edge, key_thresholds.short_edge}) <=
              threshold_denominator);

}  // namespace

const Displacement& Violations::target(Grid grid, int i, int j, int k) const {
  const DisplacedLayer& layer = targets[k];
  std::size_t at = layer.row_begin[static_cast<std::size_t>(j)];
  const auto count = [](std::uint64_t word) { return static_cast<std::size_t>(std::popcount(word)); };
  for (std::size_t before = 0; before < grid; ++before)
    for (int w = 0; w < violated.words(); ++w) at += count(violated.plus(before, j, k)[w]);
  const std::uint64_t* const row = violated.plus(grid, j, k);
  for (int w = 0; w < i >> 6; ++w) at += count(row[w]);
  at += count(row[i >> 6] & below(i & 63));
  return layer.displacements[at];
}

Violations find_violations(const SignPlanes& planes, const Layers<CutLayer>& cuts, Window around,
                           const Thresholds& thresholds, Context& context) {
  Violations found{SignPlanes(planes.cells(), around), Layers<DisplacedLayer>(around)};
  for_each_layer(context, Stage::warp, around, [&](std::int32_t k) {
    found.targets[k] = LayerViolations(planes, cuts, thresholds, k).find(found.violated);
  });
  return found;
}

}  // namespace certet::core
