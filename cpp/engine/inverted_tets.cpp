/// Whether warping has folded the lattice where nothing is kept.

#include <algorithm>
#include <array>
#include <atomic>

#include "lattice/cell_tables.hpp"
#include "certet/lattice/orientation.hpp"
#include "layer_loop.hpp"
#include "warped_lattice.hpp"

namespace certet::core {
namespace {

/// The vertices of the lattice that are zero once some have moved.
class ZeroVertices {
 public:
  ZeroVertices(const SignPlanes& moved, const Violations& violations, const Lattice& lattice)
      : moved_(moved), violations_(violations), lattice_(lattice) {}

  /// Which vertices of a word are.
  [[nodiscard]] std::uint64_t word(VertexRef ref, int j, int k, int w) const {
    return shifted(moved_.zero(ref.grid, j + ref.shift.y, k + ref.shift.z), w, ref.shift.x);
  }

  /// The position, in steps, of the one at `ref` from index (i,j,k).
  [[nodiscard]] Coord3 position(VertexRef ref, int i, int j, int k) const {
    const Coord3 home = steps * lattice_point(lattice_, ref, i, j, k);
    const int x = i + ref.shift.x;
    const int y = j + ref.shift.y;
    const int z = k + ref.shift.z;
    if (!violations_.contains(ref.grid, x, y, z)) return home;
    const Displacement& d = violations_.target(ref.grid, x, y, z);
    return home + std::int32_t{d.distance} * tiling.directions[d.direction];
  }

 private:
  const SignPlanes& moved_;
  const Violations& violations_;
  const Lattice& lattice_;
};

}  // namespace

std::uint64_t inverted_tets(const SignPlanes& moved, const Violations& violations,
                            const Lattice& lattice, Window window, Context& context) {
  const ZeroVertices zeros(moved, violations, lattice);
  std::atomic<std::uint64_t> inverted{0};
  // The lattice's last layer is its rim, and no cell begins there.
  const Window cells{window.begin, std::min(window.end, moved.cells()[2] - 1)};
  for_each_layer(context, Stage::warp, cells, [&](std::int32_t k) {
    for (int j = 0; j + 1 < moved.cells()[1]; ++j)
      for (int w = 0; w < moved.words(); ++w) {
        std::array<std::uint64_t, cell_vertex_count> zero;
        for (std::size_t v = 0; v < cell_vertex_count; ++v)
          zero[v] = zeros.word(cell.vertices[v], j, k, w);
        for (std::size_t c = 0; c < cell_tet_count; ++c) {
          const auto& corner = cell.corner[c];
          for_each_bit(zero[corner[0]] & zero[corner[1]] & zero[corner[2]] & zero[corner[3]],
                       [&](int b) {
            std::array<Coord3, 4> p;
            for (std::size_t n = 0; n < 4; ++n)
              p[n] = zeros.position(cell.vertices[corner[n]], 64 * w + b, j, k);
            const std::int64_t six_volume = certet::six_volume(p[0], p[1], p[2], p[3]);
            if (tiling.tets[c].right_handed ? six_volume <= 0 : six_volume >= 0) ++inverted;
          });
        }
      }
  });
  return inverted;
}

}  // namespace certet::core
