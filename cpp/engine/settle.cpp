#include "settle.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

#include "layer_loop.hpp"
#include "link.hpp"
#include "material_links.hpp"
#include "row_ranks.hpp"

namespace certet::core {
namespace {

// Who is near the surface settles before who is far, in four classes; of these the outer
// vertices before the inner ones; and of these one colour after the other, so that no two
// neighbours share a turn.
constexpr int nearness_classes = 4;
constexpr int colour_count = 4;
constexpr int turn_count = nearness_classes * 2 * colour_count;
static_assert(settling_halo == turn_count - 1, "each turn looks one layer further");

/// `Turn` of the certificate.  `inner` says that the vertex is plus, or of the greater of
/// two materials.
constexpr int turn_of(const VertexIndex& v, const Displacement& target, bool inner,
                      const Thresholds& thresholds, const Lattice& lattice) {
  const int nearness =
      nearness_classes * target.distance / thresholds.in_steps(target.direction);
  const Coord3& o = lattice.origin;
  const int half_sum = (o.x + o.y + o.z) / 2 + v.i + v.j + v.k + int{v.grid};
  return (nearness * 2 + int{inner}) * colour_count + 2 * v.grid + (half_sum & 1);
}

/// `StaysRather` of the certificate: to keep the one cut that violates a vertex away from it
/// moves the surface by less than a move that falls short of it.
constexpr bool stays_rather(const Displacement& target, const Displacement& kept,
                            const Thresholds& thresholds) {
  return target.is_alone && thresholds.in_steps(target.direction) - target.distance <
                                target.distance - kept.distance;
}

/// A violated vertex that has its turn to come.
struct Candidate {
  std::int32_t i, j;
  Grid grid;
  std::uint32_t target;  ///< its number in the layer
};

/// Those of one layer, by turns.
struct LayerTurns {
  std::vector<Candidate> candidates;
  std::array<std::uint32_t, turn_count + 1> begin{};
  std::uint64_t stayed = 0;
  CutShift missed;  ///< by moves that were shortened
};

LayerTurns turns_of(const SignPlanes& planes, const Violations& violations,
                    const MaterialLinks& links, const Thresholds& thresholds,
                    const Lattice& lattice, int k) {
  const std::vector<Displacement>& targets = violations.targets[k].displacements;
  LayerTurns turns;
  std::vector<Candidate> unsorted;
  std::vector<std::uint8_t> turn;
  unsorted.reserve(targets.size());
  turn.reserve(targets.size());
  for (int j = 0; j < planes.cells()[1]; ++j)
    for (const Grid grid : grids)
      for (int w = 0; w < planes.words(); ++w) {
        const std::uint64_t plus = planes.plus(grid, j, k)[w];
        for_each_bit(violations.violated.plus(grid, j, k)[w], [&](int b) {
          const auto number = static_cast<std::uint32_t>(unsorted.size());
          const VertexIndex v{grid, 64 * w + b, j, k};
          const bool inner = links.are_asked() ? links.is_greater(v, targets[number])
                                               : (plus >> b & 1) != 0;
          const int t = turn_of(v, targets[number], inner, thresholds, lattice);
          unsorted.push_back({v.i, j, grid, number});
          turn.push_back(static_cast<std::uint8_t>(t));
          ++turns.begin[static_cast<std::size_t>(t)];
        });
      }
  std::exclusive_scan(turns.begin.begin(), turns.begin.end(), turns.begin.begin(), 0U);
  std::array<std::uint32_t, turn_count + 1> next = turns.begin;
  turns.candidates.resize(unsorted.size());
  for (std::size_t n = 0; n < unsorted.size(); ++n)
    turns.candidates[next[turn[n]]++] = unsorted[n];
  return turns;
}

/// The signs of a link.
struct Link {
  LinkSet plus = 0, zero = 0;
};

/// Lets the candidates of one turn settle, layer by layer.  Threads read words in which
/// others change bits of vertices that are not neighbours of their own; only the thread
/// that works on a layer changes its words.
class Turns {
 public:
  Turns(SignPlanes& now, const SignPlanes& samples, Violations& violations,
        const MaterialLinks& links, const Thresholds& thresholds, const Lattice& lattice)
      : now_(now), samples_(samples), violations_(violations), links_(links),
        thresholds_(thresholds), lattice_(lattice),
        always_room_(steps / 2 - thresholds.in_steps(0)),
        row_stride_(64 * (now.plus(even, 1, now.window().begin) -
                          now.plus(even, 0, now.window().begin))),
        layer_stride_(64 * (now.plus(even, 0, now.window().begin) -
                            now.plus(even, 0, now.window().begin - 1))) {
    for (const Grid grid : grids)
      for (std::size_t d = 0; d < direction_count; ++d) {
        const VertexRef to = neighbor(grid, d);
        distance_[grid][d] =
            to.shift.z * layer_stride_ + to.shift.y * row_stride_ + to.shift.x;
      }
  }

  void settle(LayerTurns& layer, int turn, int k) {
    const auto t = static_cast<std::size_t>(turn);
    for (std::uint32_t n = layer.begin[t]; n < layer.begin[t + 1]; ++n) {
      const Candidate& v = layer.candidates[n];
      const Link link = link_of(v, k);
      Displacement& move = violations_.targets[k].displacements[v.target];
      Displacement kept = move;
      if (!has_disks(v, k, move, link)) {
        ++layer.stayed;
        continue;
      }
      if (is_long(move.direction) && move.distance > always_room_)
        kept.distance = stop({v.grid, v.i, v.j, k}, move, link.zero, turn);
      if (stays_rather(move, kept, thresholds_)) {
        ++layer.stayed;
        continue;
      }
      if (links_.are_asked() && !links_.may_share({v.grid, v.i, v.j, k}, kept, link.zero)) {
        ++layer.stayed;
        continue;
      }
      if (kept.distance < move.distance) layer.missed.add(move.distance - kept.distance);
      move = kept;
      become_zero(v, k);
    }
  }

 private:
  [[nodiscard]] bool has_disks(const Candidate& v, int k, const Displacement& move,
                               const Link& link) const {
    return links_.are_asked() ? links_.are_disks({v.grid, v.i, v.j, k}, move, link.zero)
                              : is_strict_disk(link.plus, link.zero);
  }

  [[nodiscard]] Link link_of(const Candidate& v, int k) const {
    std::array<std::uint64_t*, grid_count> plus{}, zero{};
    for (const Grid grid : grids) {
      plus[grid] = now_.plus(grid, v.j, k);
      zero[grid] = now_.zero(grid, v.j, k);
    }
    Link link;
    for (std::size_t d = 0; d < direction_count; ++d) {
      const std::ptrdiff_t at = v.i + distance_[v.grid][d];
      const Grid grid = neighbor(v.grid, d).grid;
      const auto bit = [&](std::uint64_t* row) {
        const std::uint64_t word = std::atomic_ref(row[at >> 6]).load(std::memory_order_relaxed);
        return static_cast<LinkSet>(word >> (at & 63) & 1) << d;
      };
      link.plus |= bit(plus[grid]);
      link.zero |= bit(zero[grid]);
    }
    return link;
  }

  /// `Shortened` of the certificate.  How far a vertex may move along a long edge: not past
  /// a neighbour that moved towards it along an edge beside, and of the way that is left to
  /// one that has its turn later only so far that both give up the same.  They may come
  /// level, so that a wall between two planes of the lattice is flat; but not if both were
  /// minus, or of the lesser material.
  [[nodiscard]] std::uint16_t stop(const VertexIndex& v, const Displacement& move, LinkSet zero,
                                   int turn) const {
    std::int32_t distance = move.distance;
    const Coord3& along = direction_offset[move.direction];
    for (std::size_t d = 6; d < direction_count; ++d) {
      const Coord3& offset = direction_offset[d];
      if (offset.x * along.x + offset.y * along.y + offset.z * along.z <= 0) continue;
      const VertexIndex w = v.next(d);
      const bool moved = (zero >> d & 1) != 0;
      if (!moved && !violations_.contains(w.grid, w.i, w.j, w.k)) continue;
      const Displacement& other = violations_.target(w.grid, w.i, w.j, w.k);
      if (other.direction != (move.direction ^ 1)) continue;
      const bool outer = is_outer(w, other);
      const std::int32_t room = steps / 2 - int{outer && is_outer(v, move)};
      if (moved)
        distance = std::min(distance, room - other.distance);
      else if (turn_of(w, other, !outer, thresholds_, lattice_) > turn)
        distance = std::min(distance, (room + move.distance - other.distance) / 2);
    }
    return static_cast<std::uint16_t>(distance);
  }

  /// Whether a vertex was minus or, of its two materials, of the lesser one.
  [[nodiscard]] bool is_outer(const VertexIndex& v, const Displacement& move) const {
    if (links_.are_asked()) return !links_.is_greater(v, move);
    return (samples_.plus(v.grid, v.j, v.k)[v.i >> 6] >> (v.i & 63) & 1) == 0;
  }

  void become_zero(const Candidate& v, int k) {
    const std::uint64_t bit = std::uint64_t{1} << (v.i & 63);
    const auto change = [&](std::uint64_t& word, const auto& changed) {
      const std::atomic_ref shared(word);
      shared.store(changed(shared.load(std::memory_order_relaxed)), std::memory_order_relaxed);
    };
    change(now_.plus(v.grid, v.j, k)[v.i >> 6], [bit](std::uint64_t word) { return word & ~bit; });
    change(now_.zero(v.grid, v.j, k)[v.i >> 6], [bit](std::uint64_t word) { return word | bit; });
  }

  SignPlanes& now_;
  const SignPlanes& samples_;
  Violations& violations_;
  const MaterialLinks& links_;
  const Thresholds& thresholds_;
  const Lattice& lattice_;
  std::int32_t always_room_;  ///< for a move along a long edge: no neighbour leaves less
  std::ptrdiff_t row_stride_, layer_stride_;  ///< in bits
  /// Of the neighbours, from a vertex's own index in a row, in bits.
  std::array<std::array<std::ptrdiff_t, direction_count>, grid_count> distance_{};
};

}  // namespace

Settling settle(const SignPlanes& planes, Violations& violations, const Thresholds& thresholds,
                const Lattice& lattice, Window window, Context& context) {
  const Window around = violations.violated.window();
  Settling settled{SignPlanes(planes, around)};
  settled.planes.clear_zeros();
  const MaterialLinks links(planes, violations, lattice);
  Layers<LayerTurns> layers(around);
  for_each_layer(context, Stage::warp, around, [&](std::int32_t k) {
    layers[k] = turns_of(planes, violations, links, thresholds, lattice, k);
  });
  Turns turns(settled.planes, planes, violations, links, thresholds, lattice);
  for (int turn = 0; turn < turn_count; ++turn)
    for_each_layer(context, Stage::warp, around,
                   [&](std::int32_t k) { turns.settle(layers[k], turn, k); });
  for (std::int32_t k = window.begin; k < window.end; ++k) {
    settled.figures.violated += layers[k].candidates.size();
    settled.figures.stayed += layers[k].stayed;
    settled.figures.shortened += layers[k].missed.cuts;
    settled.figures.missed.add(layers[k].missed);
  }
  return settled;
}

}  // namespace certet::core
