#pragma once
/// \file
/// Last stage: the numbers that a mesh is made of.
///
/// Each function writes those of the layers of `window`, which are among those of
/// `numbers`, row by row.  \throws Error `bad_option` if `out` has another size;
/// `cancelled`.

#include <algorithm>
#include <cstdint>
#include <span>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/mesh.hpp"
#include "certet/stuffing.hpp"
#include "count.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Points, in steps; those of a row in the order of RowRanks.
void emit_points(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
                 Window window, std::span<Coord3> out, Context& context);

/// Of the same points, whether they lie on the surface: 1, or 0.
void mark_surface(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
                  Window window, std::span<std::uint8_t> out, Context& context);

/// Tetrahedra: index by index, case by case, in the order of the stencil.
/// \throws Error `too_large` besides, if `Index` does not hold the number of a point.
template <class Index>
void emit_tets(const WarpedLattice& warped, const RowNumbers& numbers, const Lattice& lattice,
               Window window, std::span<Tet<Index>> out, Context& context);

/// Materials of the same tetrahedra: 1 where there is but one, else asked of the domain.  `points` are those of the
/// layers of `window` and of the layer behind it, where the lattice has one, as
/// `emit_points` writes them, `tets` those of `window`, as `emit_tets` does.
template <class Index>
void emit_materials(const Domain& domain, const RowNumbers& numbers, const Lattice& lattice,
                    Window window, std::span<const Coord3> points,
                    std::span<const Tet<Index>> tets, std::span<Material> out, Context& context);

/// Materials of the same tetrahedra where materials meet in common interfaces, so that
/// `planes` have them.
void emit_materials(const SignPlanes& planes, const RowNumbers& numbers, const Lattice& lattice,
                    Window window, std::span<Material> out, Context& context);

/// Puts labels, that of material m being labels[m - 1], in the place of materials; 0
/// for what is outside.  Calls visit(label, count) for each run of equal ones.
template <class Visit>
void labels_in_place(std::span<Material> materials, std::span<const std::int32_t> labels,
                     const Visit& visit) {
  for (auto at = materials.begin(); at != materials.end();) {
    const Material material = *at;
    const auto end =
        std::find_if(at, materials.end(), [&](Material other) { return other != material; });
    const std::int32_t label =
        material == 0 ? 0 : labels[static_cast<std::size_t>(material) - 1];
    std::fill(at, end, label);
    visit(label, static_cast<std::uint64_t>(end - at));
    at = end;
  }
}

}  // namespace certet::core
