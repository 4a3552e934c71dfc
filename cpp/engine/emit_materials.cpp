#include <algorithm>

#include "corners.hpp"
#include "emit.hpp"
#include "emit_loop.hpp"
#include "layer_loop.hpp"

namespace certet::core {

template <class Index>
void emit_materials(const Domain& domain, const RowNumbers& numbers, const Lattice& lattice,
                    Window window, std::span<const Coord3> points,
                    std::span<const Tet<Index>> tets, std::span<Material> out, Context& context) {
  const std::uint64_t first_point = numbers.first_point(0, window.begin);
  const std::uint64_t first_tet = numbers.first_tet(0, window.begin);
  const Window reached = widened(window, 0, 1, lattice);
  check_room(points.size(), numbers.first_point(0, reached.end) - first_point);
  check_room(tets.size(), numbers.first_tet(0, window.end) - first_tet);
  check_room(out.size(), tets.size());
  if (domain.labels().size() <= 1) {
    std::ranges::fill(out, 1);
    return;
  }
  for_each_layer(context, Stage::emit, window, [&](std::int32_t k) {
    const std::uint64_t begin = numbers.first_tet(0, k) - first_tet;
    const std::uint64_t end = numbers.first_tet(0, k + 1) - first_tet;
    const std::span<Material> layer = out.subspan(begin, end - begin);
    for_each_batch(points, first_point, tets.subspan(begin, end - begin),
                   [&](std::size_t from, std::span<const TetCorners> corners) {
                     domain.materials_of(corners, layer.subspan(from, corners.size()));
                   });
  });
}

template void emit_materials(const Domain&, const RowNumbers&, const Lattice&, Window,
                             std::span<const Coord3>, std::span<const Tet<std::uint32_t>>,
                             std::span<Material>, Context&);
template void emit_materials(const Domain&, const RowNumbers&, const Lattice&, Window,
                             std::span<const Coord3>, std::span<const Tet<std::uint64_t>>,
                             std::span<Material>, Context&);

}  // namespace certet::core
