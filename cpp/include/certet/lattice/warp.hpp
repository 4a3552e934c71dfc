#pragma once
/// \file
/// Warping: a vertex too close to the surface is moved onto it.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "certet/lattice/direction.hpp"
#include "certet/lattice/sign.hpp"

namespace certet {

/// Thresholds are in 256ths of an edge.
inline constexpr std::int32_t threshold_denominator = 256;

/// alpha of long and of short edges, in 256ths.
struct Thresholds {
  std::int32_t long_edge, short_edge;

  /// A vertex is violated by a cut strictly nearer than this many steps.
  [[nodiscard]] constexpr std::int32_t in_steps(int direction) const {
    return (is_long(direction) ? long_edge : short_edge) * (steps / threshold_denominator);
  }
};

inline constexpr Thresholds angle_thresholds{73, 102};
inline constexpr Thresholds embedding_thresholds{64, 105};
inline constexpr Thresholds key_thresholds{64, 95};
inline constexpr Thresholds no_warp_thresholds{0, 0};

/// What becomes of a vertex: it stays, or moves `distance` steps along an edge
/// and lands on the surface.
struct Warping {
  std::int8_t direction = -1;  ///< -1: stays
  std::int32_t distance = 0;

  [[nodiscard]] constexpr bool moves() const { return direction >= 0; }
  friend constexpr bool operator==(const Warping&, const Warping&) = default;
};

/// Decides by the cuts around a vertex: bit d of `cut_edges` says that there is
/// one in direction d, `cut[d]` steps from the vertex (other entries are
/// ignored).  The nearest violating cut wins; among equals the first direction.
constexpr Warping warp(Thresholds thresholds, std::uint32_t cut_edges,
                       const std::array<std::int32_t, direction_count>& cut) {
  Warping best;
  std::int64_t best_distance = 0;
  for (; cut_edges != 0; cut_edges &= cut_edges - 1) {
    const int d = std::countr_zero(cut_edges);
    const std::int32_t steps_to_cut = cut[static_cast<std::size_t>(d)];
    if (steps_to_cut >= thresholds.in_steps(d)) continue;
    const std::int64_t distance =
        std::int64_t{length_squared(d)} * steps_to_cut * steps_to_cut;
    if (best.moves() && distance >= best_distance) continue;
    best = {static_cast<std::int8_t>(d), steps_to_cut};
    best_distance = distance;
  }
  return best;
}

/// The same, by a vertex's sign and its neighbours'; cuts are on the edges to a
/// neighbour of opposite sign.  `Warp` of the certificate.
constexpr Warping warp(Thresholds thresholds, Sign sign,
                       const std::array<Sign, direction_count>& neighbor_sign,
                       const std::array<std::int32_t, direction_count>& cut) {
  std::uint32_t cut_edges = 0;
  for (std::size_t d = 0; d < direction_count; ++d)
    cut_edges |= std::uint32_t{opposite(sign, neighbor_sign[d])} << d;
  return warp(thresholds, cut_edges, cut);
}

}  // namespace certet
