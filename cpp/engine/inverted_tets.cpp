/// Whether warping has folded the lattice where nothing is kept.

#include <algorithm>
#include <array>
#include <atomic>

#include "certet/lattice/orientation.hpp"
#include "layer_loop.hpp"
#include "places.hpp"
#include "warped_lattice.hpp"
#include "zero_tets.hpp"

namespace certet::core {

std::uint64_t inverted_tets(const SignPlanes& moved, const Violations& violations,
                            const Lattice& lattice, Window window, Context& context) {
  const auto place = [&](const VertexIndex& v) {
    return moved_place(lattice, v, violations.contains(v.grid, v.i, v.j, v.k)
                                       ? violations.target(v.grid, v.i, v.j, v.k)
                                       : Displacement{});
  };
  std::atomic<std::uint64_t> inverted{0};
  // The lattice's last layer is its rim, and no cell begins there.
  const Window cells{window.begin, std::min(window.end, moved.cells()[2] - 1)};
  for_each_layer(context, Stage::warp, cells, [&](std::int32_t k) {
    for (int j = 0; j + 1 < moved.cells()[1]; ++j)
      for_each_zero_tet(moved, j, k, [&](const CaseIndex& tet) {
        std::array<Coord3, 4> p;
        for (std::size_t n = 0; n < 4; ++n) p[n] = place(tet.corner(n));
        const std::int64_t volume = six_volume(p[0], p[1], p[2], p[3]);
        if (tiling.tets[tet.number].right_handed ? volume <= 0 : volume >= 0) ++inverted;
      });
  });
  return inverted;
}

}  // namespace certet::core
