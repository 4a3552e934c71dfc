#pragma once
/// \file
/// The nodes of elements as files have them: corners, and behind them the middle nodes of edges
/// where the mesh has any, in the order of the format.

#include <array>
#include <cstdint>
#include <span>

#include "certet/formats.hpp"
#include "certet/middle_nodes.hpp"

namespace certet::formats {

/// Which of `tet_edges` the middle nodes of a format are in turn.
using EdgeOrder = std::array<std::uint8_t, 6>;

/// VTK, XDMF, Abaqus, Nastran, LS-DYNA, FEBio and MEDIT.
inline constexpr EdgeOrder usual_order{0, 1, 2, 3, 4, 5};
inline constexpr EdgeOrder gmsh_order{0, 1, 2, 3, 5, 4};
inline constexpr EdgeOrder tetgen_order{5, 3, 0, 1, 4, 2};

/// Numbers of points, from 0.
class ElementNodes {
 public:
  explicit ElementNodes(const MeshSize& size, const EdgeOrder& order = usual_order)
      : middles_(size.middles.get()), order_(order) {}

  [[nodiscard]] bool has_middles() const { return middles_ != nullptr; }
  [[nodiscard]] std::size_t per_tet() const { return has_middles() ? 10 : 4; }
  [[nodiscard]] std::size_t per_face() const { return has_middles() ? 6 : 3; }

  /// Until the next call.
  template <class Index>
  std::span<const std::uint64_t> tet(const Tet<Index>& corners) {
    std::copy(corners.begin(), corners.end(), nodes_.begin());
    if (!has_middles()) return {nodes_.data(), 4};
    const std::array<std::uint64_t, 6> own = middles_->of(corners);
    for (std::size_t e = 0; e < 6; ++e) nodes_[4 + e] = middles_->corners() + own[order_[e]];
    return nodes_;
  }
  /// Behind the corners those between the first two, the last two, and the last and first.
  std::span<const std::uint64_t> face(const std::array<std::uint64_t, 3>& corners) {
    std::copy(corners.begin(), corners.end(), nodes_.begin());
    if (!has_middles()) return {nodes_.data(), 3};
    for (std::size_t i = 0; i < 3; ++i)
      nodes_[3 + i] = middles_->corners() + middles_->between(corners[i], corners[(i + 1) % 3]);
    return {nodes_.data(), 6};
  }

 private:
  const MiddleNodes* middles_;
  EdgeOrder order_;
  std::array<std::uint64_t, 10> nodes_{};
};

}  // namespace certet::formats
