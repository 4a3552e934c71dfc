/// Whether warping has folded the lattice where nothing is kept.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

#include "lattice/cell_tables.hpp"
#include "certet/lattice/orientation.hpp"
#include "layer_loop.hpp"
#include "warped_lattice.hpp"

namespace certet::core {
namespace {

/// The vertices of the lattice once the violated ones have moved.
class MovedVertices {
 public:
  MovedVertices(const SignPlanes& planes, const SignPlanes& violated,
                const Layers<ZeroLayer>& moves, const Lattice& lattice)
      : planes_(planes), violated_(violated), moves_(moves), lattice_(lattice) {}

  /// Which vertices of a word are zero, moved or not.
  [[nodiscard]] std::uint64_t zero(VertexRef ref, int j, int k, int w) const {
    const int y = j + ref.shift.y;
    const int z = k + ref.shift.z;
    return shifted(planes_.zero(ref.grid, y, z), w, ref.shift.x) |
           shifted(violated_.plus(ref.grid, y, z), w, ref.shift.x);
  }

  /// The position, in steps, of the vertex at `ref` from index (i,j,k).
  [[nodiscard]] Coord3 position(VertexRef ref, int i, int j, int k) const {
    const Coord3 home = steps * lattice_point(lattice_, ref, i, j, k);
    const int x = i + ref.shift.x;
    const std::uint64_t* const row = violated_.plus(ref.grid, j + ref.shift.y, k + ref.shift.z);
    if ((row[x >> 6] >> (x & 63) & 1) == 0) return home;
    const Displacement d = move(ref.grid, x, j + ref.shift.y, k + ref.shift.z);
    return home + std::int32_t{d.distance} * tiling.directions[d.direction];
  }

 private:
  [[nodiscard]] Displacement move(Grid grid, int i, int j, int k) const {
    const ZeroLayer& layer = moves_[k];
    std::size_t at = layer.row_begin[static_cast<std::size_t>(j)];
    const auto count = [](std::uint64_t word) { return static_cast<std::size_t>(std::popcount(word)); };
    for (std::size_t before = 0; before < grid; ++before)
      for (int w = 0; w < violated_.words(); ++w) at += count(violated_.plus(before, j, k)[w]);
    const std::uint64_t* const row = violated_.plus(grid, j, k);
    for (int w = 0; w < i >> 6; ++w) at += count(row[w]);
    at += count(row[i >> 6] & below(i & 63));
    return layer.displacements[at];
  }

  const SignPlanes& planes_;
  const SignPlanes& violated_;
  const Layers<ZeroLayer>& moves_;
  const Lattice& lattice_;
};

}  // namespace

std::uint64_t Violations::inverted_tets(Context& context) const {
  const MovedVertices vertices(planes_, violated_, moves_, lattice_);
  std::atomic<std::uint64_t> inverted{0};
  // The lattice's last layer is its rim, and no cell begins there.
  const Window cells{window_.begin, std::min(window_.end, planes_.cells()[2] - 1)};
  for_each_layer(context, Stage::warp, cells, [&](std::int32_t k) {
    for (int j = 0; j + 1 < planes_.cells()[1]; ++j)
      for (int w = 0; w < planes_.words(); ++w) {
        std::array<std::uint64_t, cell_vertex_count> zero;
        for (std::size_t v = 0; v < cell_vertex_count; ++v)
          zero[v] = vertices.zero(cell.vertices[v], j, k, w);
        for (std::size_t c = 0; c < cell_tet_count; ++c) {
          const auto& corner = cell.corner[c];
          for_each_bit(zero[corner[0]] & zero[corner[1]] & zero[corner[2]] & zero[corner[3]],
                       [&](int b) {
            std::array<Coord3, 4> p;
            for (std::size_t n = 0; n < 4; ++n)
              p[n] = vertices.position(cell.vertices[corner[n]], 64 * w + b, j, k);
            const std::int64_t six_volume = certet::six_volume(p[0], p[1], p[2], p[3]);
            if (tiling.tets[c].right_handed ? six_volume <= 0 : six_volume >= 0) ++inverted;
          });
        }
      }
  });
  return inverted;
}

}  // namespace certet::core
