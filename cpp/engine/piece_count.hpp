#pragma once
/// \file
/// The pieces of a warped lattice's mesh, and where its surface is no manifold.

#include <cstdint>
#include <span>

#include "certet/pieces.hpp"
#include "warped_lattice.hpp"

namespace certet::core {

/// Of a whole lattice whose mesh has so many tetrahedra.  Where there are several materials
/// the regions are counted too, the label of material m being labels[m - 1].  Places are in
/// the world of `frame`.  \throws Error `too_large`, `cancelled`.
Pieces count_pieces(const WarpedLattice& warped, const Lattice& lattice,
                    std::span<const std::int32_t> labels, std::uint64_t tets, const Frame& frame,
                    Context& context);

}  // namespace certet::core
