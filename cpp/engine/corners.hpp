#pragma once
/// \file
/// The corners of tetrahedra, brought together from where the points are.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "certet/domain.hpp"
#include "certet/mesh.hpp"

namespace certet::core {

/// So many at a time.
inline constexpr std::size_t batch_size = 256;

/// Calls visit(begin, corners) for the tetrahedra from `begin` on, batch by
/// batch.  `points` are all that the tetrahedra name, the first of them having
/// number `first_point`.
template <class Index, class Visit>
void for_each_batch(std::span<const Coord3> points, std::uint64_t first_point,
                    std::span<const Tet<Index>> tets, const Visit& visit) {
  std::array<TetCorners, batch_size> corners;
  for (std::size_t begin = 0; begin < tets.size(); begin += corners.size()) {
    const std::size_t count = std::min(corners.size(), tets.size() - begin);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t v = 0; v < 4; ++v)
        corners[i][v] = points[tets[begin + i][v] - first_point];
    visit(begin, std::span<const TetCorners>(corners).first(count));
  }
}

}  // namespace certet::core
