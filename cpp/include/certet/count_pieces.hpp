#pragma once
/// \file
/// The pieces of a mesh in memory, of which nothing is known but its numbers.

#include <cstdint>
#include <span>

#include "certet/context.hpp"
#include "certet/mesh.hpp"
#include "certet/pieces.hpp"

namespace certet {

/// Counts the pieces of the whole and of each label, and finds where the surface is no
/// manifold; all faces are compared.  `labels` is empty or as long as `tets`; tetrahedra
/// that name a point which is not there, or one twice, are left out.  Takes some 20 bytes
/// for each tetrahedron and each point, beside the mesh.
///
/// The result does not depend on the number of threads.  \throws Error `cancelled`.
Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels, Context& context);
Pieces count_pieces(std::span<const Point3> points, std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels, Context& context);
/// Of a mesh with its labels, in world coordinates.  \throws Error `too_large` besides.
Pieces count_pieces(const Mesh& mesh, Context& context);

}  // namespace certet
