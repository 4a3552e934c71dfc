#pragma once
/// \file
/// The displacements that zero vertices keep when the signs have changed.

#include <cstddef>
#include <cstdint>

#include "row_ranks.hpp"
#include "violations.hpp"

namespace certet::core {

/// Of the displacements of layer k, those of vertices that are 0 in `after`; the bits of
/// had(grid, j) tell which vertices of a row have one.
template <class Had>
DisplacedLayer displaced_left(const DisplacedLayer& displaced, const Had& had,
                              const SignPlanes& after, int k) {
  DisplacedLayer left;
  std::size_t next = 0;
  for (int j = 0; j < after.cells()[1]; ++j) {
    left.row_begin.push_back(static_cast<std::uint32_t>(left.displacements.size()));
    for (const Grid grid : grids) {
      const std::uint64_t* const words = had(grid, j);
      for (int w = 0; w < after.words(); ++w) {
        const std::uint64_t zero = after.zero(grid, j, k)[w];
        for_each_bit(words[w], [&](int b) {
          const Displacement& own = displaced.displacements[next++];
          if ((zero >> b & 1) != 0) left.displacements.push_back(own);
        });
      }
    }
  }
  return left;
}

}  // namespace certet::core
