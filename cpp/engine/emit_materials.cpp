#include <algorithm>

#include "corners.hpp"
#include "emit.hpp"
#include "emit_loop.hpp"
#include "graded_vertices.hpp"
#include "layer_loop.hpp"
#include "material_cells.hpp"

namespace certet::core {
namespace {

/// The materials of the tetrahedra of row (j,k), from `out` on.
void emit_row_materials(const SignPlanes& planes, int j, int k, Material* out) {
  const MaterialCells cells(planes, j, k);
  for (int w = 0; w < planes.words(); ++w) {
    const auto [any, whole] = cells.kinds(w);
    for_each_bit(any, [&, whole = whole](int b) {
      const int i = 64 * w + b;
      if ((whole >> b & 1) != 0)
        out = std::fill_n(out, cell_tet_count, cells.material_of_whole(i));
      else
        cells.for_each_tet(i, [&](std::size_t, const UnstructuredTet&, Material material) {
          *out++ = material;
        });
    });
  }
}

/// The same where the mesh is graded, of what it has from the lattice.
Material* emit_structured_materials(const SignPlanes& planes, const GradedCells& graded, int j,
                                    int k, Material* out) {
  const MaterialCells cells(planes, j, k);
  for (int w = 0; w < planes.words(); ++w) {
    const OfCases structured = graded.structured(j, k, w);
    for_each_bit(cells.kinds(w).any, [&](int b) {
      cells.for_each_tet(64 * w + b, [&](std::size_t c, const UnstructuredTet&, Material material) {
        if ((structured[c] >> b & 1) != 0) *out++ = material;
      });
    });
  }
  return out;
}

/// Those of the others: of one of their vertices, which are all of one material.
void emit_graded_materials(const SignPlanes& planes, const Octree& octree, int j, int k,
                           Material* out) {
  const MaterialPlanes& materials = *planes.materials();
  for_each_graded_row(octree, j, k, [&](const GradedRow& row, int level, const RowOfCells& at) {
    if (level == 0) {
      row.for_each_in_row([&](int w, GradedKind, std::size_t, std::uint64_t cells) {
        for_each_bit(cells, [&](int b) { *out++ = materials.at(odd, 64 * w + b, j, k); });
      });
      return;
    }
    const GradedVertices vertices(octree, level, at);
    row.for_each_in_row([&](int w, GradedKind kind, std::size_t flag, std::uint64_t cells) {
      const CoarseVertex first = coarse_tets[static_cast<std::size_t>(kind)][flag][0];
      const auto [y, z] = vertices.row(first.row);
      const MaterialRow along = materials.row(even, y, z);
      for_each_bit(cells, [&](int b) { *out++ = along.at(vertices.index(first, 64 * w + b)); });
    });
  });
}

}  // namespace

void emit_materials(const SignPlanes& planes, const RowNumbers& numbers, const Lattice& lattice,
                    Window window, std::span<Material> out, Context& context) {
  const std::uint64_t start = numbers.first_tet(0, window.begin);
  check_room(out.size(), numbers.first_tet(0, window.end) - start);
  for_each_piece(lattice, window, context, [&](int j_begin, int j_end, int k) {
    for (int j = j_begin; j < j_end; ++j) {
      Material* const to = out.data() + (numbers.first_tet(j, k) - start);
      if (const GradedCells* const graded = numbers.graded(); graded == nullptr)
        emit_row_materials(planes, j, k, to);
      else
        emit_graded_materials(planes, graded->octree(), j, k,
                              emit_structured_materials(planes, *graded, j, k, to));
    }
  });
}

template <class Index>
void emit_materials(const Domain& domain, const RowNumbers& numbers, const Lattice& lattice,
                    Window window, std::span<const Coord3> points,
                    std::span<const Tet<Index>> tets, std::span<Material> out, Context& context) {
  const std::uint64_t first_point = numbers.first_point(0, window.begin);
  const std::uint64_t first_tet = numbers.first_tet(0, window.begin);
  const GradedCells* const graded = numbers.graded();
  const Window reached =
      widened(window, 0, graded == nullptr ? 1 : graded->layers_behind(), lattice);
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
